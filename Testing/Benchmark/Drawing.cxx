// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing.h"

#include "Effects.h"
#include "Errors.h"
#include "ExactPicture.h"
#include "Failure.h"
#include "FloatPicture.h"
#include "GLDescription.h"
#include "Mappers.h"
#include "OffscreenWindow.h"
#include "Parity.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkMultiThreader.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkSMPTools.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkTimerLog.h"
#include "vtkVersion.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace tetmarch::bench
{
namespace
{
// Oblique, so that no face of a lattice is seen edge on.
constexpr double ViewDirection[3] = { 0.5, -1.0, 0.45 };
// A frame may not live on what the one before it has sorted.
constexpr double DegreesPerFrame = 7.0;
// Seconds. Without a limit, nobody would wait for the light at vertices, and its clock be wrong.
constexpr double EnoughForOneDraw = 1e6;

void rememberError(vtkObject*, unsigned long, void* error, void* text)
{
  *static_cast<std::string*>(error) = text ? static_cast<const char*>(text) : "unknown error";
}

void readPixels(vtkRenderWindow* window, vtkUnsignedCharArray* pixels)
{
  const int* size = window->GetSize();
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
}
} // namespace

Drawing::Drawing(Scene scene, std::string mapper, const std::array<int, 2>& size)
  : Shown(std::move(scene))
  , MapperName(std::move(mapper))
{
  std::string error;
  this->Window = MakeOffscreenWindow(size[0], size[1], &error);
  if (!this->Window)
  {
    throw Failure("no offscreen OpenGL: " + error);
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(ViewDirection);
  camera->SetViewUp(0.0, 0.0, 1.0);
  this->Renderer->ResetCamera(this->Shown.Grid->GetBounds());
  camera->GetPosition(this->FirstPosition.data());
  this->Window->AddRenderer(this->Renderer);
  this->Window->Render();
  this->Window->WaitForCompletion();
  readPixels(this->Window, this->Background);
}

nlohmann::json Drawing::drawFrame()
{
  this->setView(this->Frames++);
  const double seconds = this->timeFrame();
  return { { "seconds", seconds }, { "covered", this->coveredShare() } };
}

vtkTetMarchVolumeMapper* Drawing::setEffect(const std::string& effect)
{
  this->ensureVolume();
  vtkTetMarchVolumeMapper* mapper = this->ours();
  if (!mapper)
  {
    throw Failure(this->MapperName + " has no effects");
  }
  mapper->SetMaxDrawTimeInSeconds(EnoughForOneDraw);
  EffectScene scene{ this->Renderer, mapper, this->Shown.Property, {},
    this->Shown.Range.High - this->Shown.Range.Low };
  this->Shown.Grid->GetBounds(scene.Bounds.data());
  applyEffect(effect, scene);
  return mapper;
}

nlohmann::json Drawing::drawEffect(const std::string& effect, int view)
{
  this->setView(view);
  vtkTetMarchVolumeMapper* mapper = this->setEffect(effect);
  const vtkTypeInt64 gradients = mapper->GetGradientsBuilds();
  const vtkTypeInt64 light = mapper->GetVertexLightBuilds();
  const double first = this->timeFrame();
  const double seconds = this->timeFrame();
  const auto ran = [](vtkTypeInt64 before, vtkTypeInt64 after, double took)
  { return after > before ? took : 0.0; };
  return { { "first_seconds", first }, { "seconds", seconds },
    { "gradients_seconds",
      ran(gradients, mapper->GetGradientsBuilds(), mapper->GetGradientsSeconds()) },
    { "light_seconds",
      ran(light, mapper->GetVertexLightBuilds(), mapper->GetVertexLightSeconds()) },
    { "gpu_bytes", mapper->GetGPUMemoryBytes() }, { "covered", this->coveredShare() } };
}

double Drawing::timeFrame()
{
  const double begin = vtkTimerLog::GetUniversalTime();
  const double owed = this->ensureVolume();
  this->Window->Render();
  this->Window->WaitForCompletion();
  const double seconds = vtkTimerLog::GetUniversalTime() - begin + owed;
  this->failOnError();
  return seconds;
}

double Drawing::ensureVolume()
{
  if (this->Volume)
  {
    return 0.0;
  }
  const PreparedVolume prepared = makeVolume(this->MapperName, this->Shown);
  this->Volume = prepared.Volume;
  vtkNew<vtkCallbackCommand> onError;
  onError->SetCallback(rememberError);
  onError->SetClientData(&this->Error);
  this->Volume->GetMapper()->AddObserver(vtkCommand::ErrorEvent, onError);
  this->Renderer->AddVolume(this->Volume);
  return prepared.OwedSeconds;
}

void Drawing::setView(int frame)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(this->FirstPosition.data());
  camera->Azimuth(DegreesPerFrame * frame);
  this->Renderer->ResetCameraClippingRange(this->Shown.Grid->GetBounds());
}

void Drawing::failOnError() const
{
  if (!this->Error.empty())
  {
    throw Failure(this->Error);
  }
}

/// The share of the pixels that differ from the background; throws Failure if none do.
double Drawing::coveredShare()
{
  vtkNew<vtkUnsignedCharArray> pixels;
  readPixels(this->Window, pixels);
  const vtkIdType count = pixels->GetNumberOfTuples();
  vtkIdType covered = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const unsigned char* now = pixels->GetPointer(3 * i);
    covered += !std::equal(now, now + 3, this->Background->GetPointer(3 * i));
  }
  if (covered == 0)
  {
    throw Failure("the picture is empty");
  }
  return static_cast<double>(covered) / static_cast<double>(count);
}

vtkTetMarchVolumeMapper* Drawing::ours() const
{
  return this->Volume ? vtkTetMarchVolumeMapper::SafeDownCast(this->Volume->GetMapper()) : nullptr;
}

nlohmann::json Drawing::mapperFigures() const
{
  nlohmann::json figures;
  if (this->Volume)
  {
    figures["class"] = this->Volume->GetMapper()->GetClassName();
  }
  if (vtkTetMarchVolumeMapper* ours = this->ours())
  {
    figures["stages"] = { { "mesh", ours->GetMeshSeconds() },
      { "scalars", ours->GetScalarsSeconds() }, { "tables", ours->GetTablesSeconds() },
      { "visible_part", ours->GetVisiblePartSeconds() }, { "upload", ours->GetUploadSeconds() } };
    figures["entries_seconds"] = ours->GetEntriesSeconds();
    figures["gpu_bytes"] = ours->GetGPUMemoryBytes();
    figures["uploaded_bytes"] = ours->GetUploadedBytes();
  }
  return figures;
}

nlohmann::json Drawing::compareFirstView(const std::string& file)
{
  this->setView(0);
  this->ensureVolume();
  const bool projected = vtkProjectedTetrahedraMapper::SafeDownCast(this->Volume->GetMapper());
  const FloatPictures pictures = projected ? drawInBytes(this->Window, this->Renderer)
                                           : drawInFloat(this->Window, this->Renderer);
  this->failOnError();
  nlohmann::json errors = errorsOf(pictures, readReference(file, pictures.OnBlack));
  if (vtkTetMarchVolumeMapper* ours = this->ours())
  {
    ours->CollectDiagnosticsOn();
    this->Window->Render();
    ours->CollectDiagnosticsOff();
    this->failOnError();
    const auto cells = static_cast<double>(ours->GetNumberOfCrossedCells());
    errors["lookups_per_cell"] = static_cast<double>(ours->GetNumberOfLookups()) / cells;
    errors["cells_per_ray"] = cells / static_cast<double>(ours->GetNumberOfRays());
    vtkTetMarchFrameStatistics* statistics = ours->GetLastFrameStatistics();
    errors["bound_max"] = statistics->GetMaximum(vtkTetMarchFrameStatistics::ERROR_BOUND);
  }
  return errors;
}

nlohmann::json Drawing::compareWithCpu(const std::string& effect)
{
  this->setView(0);
  vtkTetMarchVolumeMapper* mapper = this->setEffect(effect);
  this->timeFrame();
  nlohmann::json parity = measureParity(this->Window, mapper, this->Volume);
  this->failOnError();
  return parity;
}

nlohmann::json Drawing::writeReference(const std::string& file)
{
  const double begin = vtkTimerLog::GetUniversalTime();
  this->setView(0);
  if (this->Shown.Exact)
  {
    writePicture(file, exactPicture(*this->Shown.Exact, this->Shown.Property, this->Renderer));
  }
  else
  {
    this->ensureVolume();
    this->Window->Render();
    this->failOnError();
    vtkNew<vtkFloatArray> pixels;
    if (!this->ours() || !this->ours()->RenderGroundTruth(this->Volume, pixels))
    {
      throw Failure("there is no reference: " + this->Error);
    }
    const int* size = this->Window->GetSize();
    writePicture(file, testing::Image::fromFloats(size[0], size[1], pixels->GetPointer(0)));
  }
  return { { "seconds", vtkTimerLog::GetUniversalTime() - begin } };
}

nlohmann::json Drawing::gl() const { return describeGL(this->Window); }

nlohmann::json Drawing::driverProbes() const { return probeDriver(this->Window); }

nlohmann::json Drawing::environment() const { return describeEnvironment(this->Window); }

nlohmann::json describeEnvironment(vtkRenderWindow* window)
{
  const GLInformation gl = GetGLInformation(window);
  return { { "gl", { { "backend", gl.Backend }, { "vendor", gl.Vendor },
                     { "renderer", gl.Renderer }, { "version", gl.Version } } },
    { "vtk_version", vtkVersion::GetVTKVersion() },
    { "smp", { { "backend", vtkSMPTools::GetBackend() },
               { "threads", vtkSMPTools::GetEstimatedNumberOfThreads() } } },
    { "multithreader_threads", vtkMultiThreader::GetGlobalDefaultNumberOfThreads() } };
}
} // namespace tetmarch::bench
