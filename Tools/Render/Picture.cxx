// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "DatasetReader.h"
#include "Failure.h"
#include "Messages.h"
#include "OffscreenWindow.h"
#include "ProgressBar.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkAutoInit.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTetMarchFirstPicture.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkTetMarchSettings.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"
#include "vtkWindowToImageFilter.h"

#include <filesystem>

// The text of the legend.
VTK_MODULE_INIT(vtkRenderingFreeType);

namespace
{
using namespace tetmarch;

bool ShowsMeasure(int viewMode)
{
  return viewMode == vtkTetMarchSettings::VIEW_ERROR_BOUND ||
         viewMode == vtkTetMarchSettings::VIEW_CELLS ||
         viewMode == vtkTetMarchSettings::VIEW_LOOKUPS;
}

bool ShowsBoundary(int viewMode)
{
  return viewMode == vtkTetMarchSettings::VIEW_BOUNDARY_FACES ||
         viewMode == vtkTetMarchSettings::VIEW_BOUNDARY_COORDINATES;
}

/// What a picture of several blocks has not, that are drawn one over the other; else nullptr.
const char* FindOptionOfOneBlock(const CommandLine& commandLine)
{
  const int blend = commandLine.BlendMode;
  return commandLine.Pixel                    ? "--pixel"
         : commandLine.Compare                ? "--compare"
         : ShowsMeasure(commandLine.ViewMode) ? "--view error, cells or lookups"
         : blend != vtkVolumeMapper::COMPOSITE_BLEND && blend != vtkVolumeMapper::ISOSURFACE_BLEND
           ? "--blend other than composite or isosurface"
           : nullptr;
}

void CheckOptions(const VolumeData& data, const CommandLine& commandLine)
{
  const std::string input = "'" + commandLine.Input + "'";
  if (!data.Structured && commandLine.Nearest)
  {
    throw Failure("--interpolation is for images and rectilinear grids, but " + input +
                  " is drawn as an unstructured grid");
  }
  if (!data.Structured && commandLine.AccuracyLevel == vtkTetMarchSettings::SAMPLED)
  {
    throw Failure("--accuracy sampled and --sample-distance are for images and rectilinear grids, "
                  "but " +
                  input + " is drawn as an unstructured grid");
  }
  if (data.Structured && ShowsBoundary(commandLine.ViewMode))
  {
    throw Failure("--view faces and --view coordinates show the boundary of an unstructured grid, "
                  "but " +
                  input + " has images or rectilinear grids");
  }
  const char* ofOne = FindOptionOfOneBlock(commandLine);
  if (data.Structured && data.Blocks.size() > 1 && ofOne)
  {
    throw Failure(std::string(ofOne) + " is for one image or rectilinear grid, but " + input +
                  " has " + std::to_string(data.Blocks.size()) +
                  ", which are drawn one over the other");
  }
}
} // namespace

namespace tetmarch
{

Picture::Picture(
  const VolumeData& data, vtkTetMarchFirstPicture* choice, const CommandLine& commandLine)
  : Mapper(MakeMapper(data.Structured))
{
  CheckOptions(data, commandLine);
  std::string error;
  this->Window = MakeOffscreenWindow(commandLine.Size[0], commandLine.Size[1], &error);
  if (!this->Window)
  {
    throw Failure("no offscreen OpenGL: " + error);
  }
  this->Volume->SetMapper(this->Mapper->GetMapper());
  choice->ApplyTo(this->Volume);
  this->SetUpMapper(data, commandLine);
  this->SetUpProperty(commandLine);
  this->Legend->SetMapper(this->Mapper->GetMapper());

  const auto& background = commandLine.Background;
  this->Renderer->SetBackground(background[0], background[1], background[2]);
  this->Renderer->AddVolume(this->Volume);
  this->Renderer->AddViewProp(this->Legend);
  for (const std::string& path : commandLine.Surfaces)
  {
    this->AddSurface(path);
  }
  this->Window->AddRenderer(this->Renderer);
  SetUpLight(
    commandLine.Light, this->Renderer, this->Volume->GetProperty(), this->Mapper->GetSettings());
  this->PlaceCamera(choice, commandLine);
}

void Picture::SetUpMapper(const VolumeData& data, const CommandLine& commandLine)
{
  this->Mapper->SetInput(data.Input);
  this->Mapper->SetBlendMode(commandLine.BlendMode);
  SetUpCuts(commandLine.Cuts, *this->Mapper);

  if (commandLine.AccuracyLevel == vtkTetMarchSettings::SAMPLED)
  {
    this->Mapper->SetSamples(commandLine.SampleDistance.value_or(-1.0), commandLine.Jitter);
  }

  vtkTetMarchSettings* settings = this->Mapper->GetSettings();
  settings->SetAccuracyLevel(commandLine.AccuracyLevel);
  settings->SetErrorTolerance(commandLine.Tolerance.value_or(settings->GetErrorTolerance()));
  settings->SetFrameTimeBudget(commandLine.FrameTime);
  settings->SetErrorBudget(commandLine.Error);
  settings->SetViewMode(commandLine.ViewMode);
  settings->SetDrawNanCells(!commandLine.NanColor.empty());
}

void Picture::SetUpProperty(const CommandLine& commandLine)
{
  vtkVolumeProperty* property = this->Volume->GetProperty();
  if (!commandLine.NanColor.empty())
  {
    const std::vector<double>& rgba = commandLine.NanColor;
    property->GetRGBTransferFunction()->SetNanColorRGBA(rgba[0], rgba[1], rgba[2], rgba[3]);
  }
  property->SetInterpolationType(
    commandLine.Nearest.value_or(false) ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
  vtkContourValues* surfaces = property->GetIsoSurfaceValues();
  surfaces->SetNumberOfContours(static_cast<int>(commandLine.IsoValues.size()));
  for (std::size_t i = 0; i < commandLine.IsoValues.size(); ++i)
  {
    surfaces->SetValue(static_cast<int>(i), commandLine.IsoValues[i]);
  }
}

void Picture::AddSurface(const std::string& path)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(ReadSurface(path));
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.8, 0.8, 0.8);
  this->Renderer->AddActor(actor);
}

void Picture::PlaceCamera(vtkTetMarchFirstPicture* choice, const CommandLine& commandLine)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  if (commandLine.Camera)
  {
    const CameraOption& option = *commandLine.Camera;
    camera->SetPosition(option.Position.data());
    camera->SetFocalPoint(option.FocalPoint.data());
    camera->SetViewUp(option.ViewUp.data());
    camera->SetViewAngle(option.ViewAngle.value_or(30.0));
  }
  else
  {
    const double aspect = static_cast<double>(commandLine.Size[0]) / commandLine.Size[1];
    choice->PlaceCamera(camera, aspect);
  }
  if (commandLine.ParallelScale)
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(*commandLine.ParallelScale);
  }
  this->Renderer->ResetCameraClippingRange();
}

double Picture::Render()
{
  const int errorsBefore = Messages::GetNumberOfErrors();
  const double begin = vtkTimerLog::GetUniversalTime();
  {
    ProgressBar progress("rendering", this->Mapper->GetMapper());
    this->Window->Render();
    this->Window->WaitForCompletion();
  }
  const double seconds = vtkTimerLog::GetUniversalTime() - begin;
  if (Messages::GetNumberOfErrors() > errorsBefore)
  {
    throw Failure("rendering failed");
  }
  return seconds;
}

void Picture::Settle()
{
  constexpr int longEnough = 12; // a better level is tried sooner
  constexpr int most = 200;
  double tolerance = this->Mapper->GetStatistics()->GetUsedErrorTolerance();
  for (int same = 0, i = 0; same < longEnough && i < most; ++i)
  {
    this->Render();
    same = this->Mapper->GetStatistics()->GetUsedErrorTolerance() == tolerance ? same + 1 : 0;
    tolerance = this->Mapper->GetStatistics()->GetUsedErrorTolerance();
  }
}

void Picture::Compare()
{
  this->Mapper->GetSettings()->CollectDiagnosticsOn();
  this->Render();
  if (!this->Mapper->CompareWithGroundTruth(this->Volume))
  {
    throw Failure("the picture could not be compared");
  }
}

void Picture::Trace(const std::array<int, 2>& pixel, PixelTrace& trace)
{
  this->Mapper->GetSettings()->CollectDiagnosticsOn();
  this->Render();
  const int* size = this->Window->GetSize();
  const int x = pixel[0];
  const int y = size[1] - 1 - pixel[1]; // rows of windows begin at the bottom
  vtkNew<vtkFloatArray> drawn;
  this->Mapper->GetDiagnosticPixels(drawn);
  if (drawn->GetNumberOfTuples() == 0)
  {
    throw Failure("there is nothing to draw, so no ray is marched");
  }
  drawn->GetTuple(vtkIdType(y) * size[0] + x, trace.Drawn.data());
  for (const auto& [arithmetic, cells] :
    { std::pair<TraceIn, vtkTable*>{ TraceIn::FLOAT, trace.Float },
      { TraceIn::DOUBLE, trace.Double }, { TraceIn::GROUND_TRUTH, trace.GroundTruth } })
  {
    if (!this->Mapper->TraceRay(this->Volume, x, y, arithmetic, cells))
    {
      throw Failure("the ray of the pixel could not be marched");
    }
  }
}

void Picture::Write(const std::string& path)
{
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(this->Window);
  image->ShouldRerenderOff();
  image->ReadFrontBufferOff();
  image->SetInputBufferTypeToRGB();

  const int errorsBefore = Messages::GetNumberOfErrors();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
  if (Messages::GetNumberOfErrors() > errorsBefore || !std::filesystem::exists(path))
  {
    throw Failure("cannot write '" + path + "'");
  }
}

} // namespace tetmarch
