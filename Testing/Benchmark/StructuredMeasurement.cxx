// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StructuredMeasurement.h"

#include "Drawing.h"
#include "Errors.h"
#include "Failure.h"
#include "FloatPicture.h"
#include "OffscreenWindow.h"
#include "StructuredFunctions.h"
#include "StructuredMappers.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkTetMarchSmartVolumeMapper.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>
#include <set>

namespace tetmarch::bench
{
namespace
{
using testing::Image;

// Oblique, so that no face of a cell is seen edge on.
constexpr double ViewDirection[3] = { 0.5, -1.0, 0.45 };
constexpr double DegreesPerTurn = 7.0;

double now() { return vtkTimerLog::GetUniversalTime(); }

/// One window with one volume at a time, seen from the views of the turns.
class Stage
{
public:
  Stage(const std::array<int, 2>& size, vtkImageData* image)
  {
    std::string error;
    this->Window = MakeOffscreenWindow(size[0], size[1], &error);
    if (!this->Window)
    {
      throw Failure("no offscreen OpenGL: " + error);
    }
    image->GetBounds(this->Bounds.data());
    this->Window->AddRenderer(this->Renderer);
    this->Window->Render();
    this->Framebuffer = std::make_unique<FloatFramebuffer>(this->Window, this->Renderer);
    this->OnError->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
      { *static_cast<std::string*>(text) = static_cast<const char*>(message); });
    this->OnError->SetClientData(&this->Error);
  }

  void setView(int turn, double windowCenter = 0.0)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(ViewDirection);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCamera(this->Bounds.data());
    camera->Azimuth(DegreesPerTurn * turn);
    camera->SetWindowCenter(windowCenter, windowCenter);
    this->Renderer->ResetCameraClippingRange(this->Bounds.data());
  }

  /// Seconds. Throws Failure if the mapper reports an error.
  double draw(vtkVolume* volume)
  {
    if (!this->Renderer->HasViewProp(volume))
    {
      volume->GetMapper()->AddObserver(vtkCommand::ErrorEvent, this->OnError);
      this->Renderer->AddVolume(volume);
    }
    this->Error.clear();
    const double begin = now();
    this->Window->Render();
    this->Window->WaitForCompletion();
    const double seconds = now() - begin;
    this->failOnError();
    return seconds;
  }

  Image picture() const { return this->Framebuffer->read(); }
  vtkRenderWindow* window() const { return this->Window; }

  /// What is on the window now by the march in double precision; Throws Failure.
  Image groundTruth(vtkVolume* volume)
  {
    auto* mapper = vtkTetMarchSmartVolumeMapper::SafeDownCast(volume->GetMapper());
    vtkNew<vtkFloatArray> pixels;
    if (!mapper || !mapper->RenderGroundTruth(volume, pixels))
    {
      throw Failure("there is no reference: " + this->Error);
    }
    const int* size = this->Window->GetSize();
    return Image::fromFloats(size[0], size[1], pixels->GetPointer(0));
  }

private:
  void failOnError() const
  {
    if (!this->Error.empty())
    {
      throw Failure(this->Error);
    }
  }

  std::string Error;
  std::array<double, 6> Bounds;
  vtkNew<vtkCallbackCommand> OnError;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  std::unique_ptr<FloatFramebuffer> Framebuffer; // gone before the window
};

/// The pixels of a picture whose rays a window that is `stride` times smaller has, if its centre is
/// moved as windowCenterOf() says.
int offsetOf(int stride) { return (stride - 1) / 2; }

Image everyNth(const Image& image, int stride)
{
  Image result(image.Width / stride, image.Height / stride);
  for (int y = 0; y < result.Height; ++y)
  {
    for (int x = 0; x < result.Width; ++x)
    {
      const int offset = offsetOf(stride);
      const float* pixel = image.pixel(x * stride + offset, y * stride + offset);
      std::copy(pixel, pixel + 4, result.pixel(x, y));
    }
  }
  return result;
}

/// In halves of the window's width: from the middle of a large pixel to that of the small one.
double windowCenterOf(int width, int stride)
{
  return 2.0 * (offsetOf(stride) + 0.5 - 0.5 * stride) / width;
}

Image makeReference(
  const Options& options, const StructuredVolume& shown, vtkVolumeProperty* property)
{
  const std::array<int, 2> size{ { options.Size[0] / options.Stride,
    options.Size[1] / options.Stride } };
  StructuredScene scene(shown, property);
  vtkVolume* volume = scene.show("tetmarch");
  Stage stage(size, shown.Stored);
  stage.setView(0, windowCenterOf(options.Size[0], options.Stride));
  stage.draw(volume);
  return stage.groundTruth(volume);
}

/// Of one mapper in the run through all turns.
struct Contestant
{
  MapperRecord& Record;
  double Seconds = 0.0;
};

class Tournament
{
public:
  Tournament(const Options& options, StructuredScene& scene, const Image& reference)
    : Chosen(options)
    , Scene(scene)
    , Shown(options.Size, scene.Shown.Stored)
    , Reference(reference)
  {
  }

  nlohmann::json environment() const { return describeEnvironment(this->Shown.window()); }

  void takeTurn(Contestant& contestant, int turn)
  {
    MapperRecord& record = contestant.Record;
    if (!record.Failure.empty() || (turn > 0 && contestant.Seconds >= this->Chosen.EnoughSeconds))
    {
      return;
    }
    try
    {
      vtkVolume* volume = this->Scene.show(record.Mapper);
      this->Shown.setView(turn);
      if (this->Drawn.insert(volume).second)
      {
        record.FirstFrames.push_back(this->Shown.draw(volume));
      }
      record.Figures["class"] = volume->GetMapper()->GetClassName();
      const std::clock_t before = std::clock();
      record.Frames.push_back(this->Shown.draw(volume));
      record.Figures["cpu_seconds"].push_back(
        static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
      contestant.Seconds += record.Frames.back();
      if (turn == 0)
      {
        record.Errors =
          errorsOnBlack(everyNth(this->Shown.picture(), this->Chosen.Stride), this->Reference);
      }
      std::fprintf(stderr, "  %-20s turn %d: %.4f s, %.4f s of the CPU %s\n", record.Mapper.c_str(),
        turn, record.Frames.back(), record.Figures["cpu_seconds"].back().get<double>(),
        turn == 0 ? record.Errors.dump().c_str() : "");
    }
    catch (const std::exception& error)
    {
      record.Failure = "turn " + std::to_string(turn) + ": " + error.what();
      std::fprintf(stderr, "  %-20s %s\n", record.Mapper.c_str(), record.Failure.c_str());
    }
  }

private:
  const Options& Chosen;
  StructuredScene& Scene;
  Stage Shown;
  const Image& Reference;
  std::set<vtkVolume*> Drawn;
};

void runTurns(
  const Options& options, StructuredScene& scene, const Image& reference, StructuredRecord& record)
{
  Tournament tournament(options, scene, reference);
  record.Environment = tournament.environment();
  std::vector<Contestant> contestants;
  for (MapperRecord& mapper : record.Mappers)
  {
    contestants.push_back({ mapper });
  }
  for (int turn = 0; turn < options.Frames; ++turn)
  {
    for (std::size_t i = 0; i < contestants.size(); ++i)
    {
      // There and back, so that a machine that gets slower or faster does so for all.
      tournament.takeTurn(contestants[turn % 2 ? contestants.size() - 1 - i : i], turn);
    }
  }
}
} // namespace

StructuredRecord measureStructured(const Options& options, const Subject& subject)
{
  std::fprintf(stderr, "%s, %s\n", subject.Dataset.c_str(), subject.Functions.c_str());
  if (options.Size[0] != options.Size[1] || options.Size[0] % options.Stride != 0)
  {
    throw Failure("images are drawn into a square window whose edge is a multiple of the stride");
  }
  const StructuredVolume volume = makeStructuredVolume(subject.Dataset, options.Folders);
  const auto property = makeStructuredFunctions(subject.Functions, volume.Range);
  StructuredRecord record;
  record.Shown = subject;
  volume.Stored->GetDimensions(record.Dimensions.data());
  record.ScalarType = volume.Stored->GetPointData()->GetScalars()->GetDataTypeAsString();
  for (const std::string& mapper : options.Mappers)
  {
    if (!isRedundant(mapper, volume))
    {
      record.Mappers.push_back({});
      record.Mappers.back().Mapper = mapper;
    }
  }
  const double begin = now();
  const Image reference = makeReference(options, volume, property);
  record.ReferenceSeconds = now() - begin;
  std::fprintf(stderr, "  reference: %.1f s\n", record.ReferenceSeconds);
  StructuredScene scene(volume, property);
  runTurns(options, scene, reference, record);
  return record;
}
} // namespace tetmarch::bench
