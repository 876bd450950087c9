// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "DatasetReader.h"
#include "DefaultCamera.h"
#include "Failure.h"
#include "Messages.h"
#include "OffscreenWindow.h"
#include "ProgressBar.h"

#include "vtkActor.h"
#include "vtkAutoInit.h"
#include "vtkCamera.h"
#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTimerLog.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <filesystem>

// The text of the legend.
VTK_MODULE_INIT(vtkRenderingFreeType);

namespace tetmarch
{

Picture::Picture(vtkUnstructuredGrid* grid, const ArraySelection& selection,
  const TransferFunctions& functions, double unitDistance, const CommandLine& commandLine)
{
  std::string error;
  this->Window = MakeOffscreenWindow(commandLine.Size[0], commandLine.Size[1], &error);
  if (!this->Window)
  {
    throw Failure("no offscreen OpenGL: " + error);
  }

  this->Mapper->SetInputData(grid);
  this->Mapper->SetScalarMode(selection.Where == Association::POINTS
                                ? VTK_SCALAR_MODE_USE_POINT_FIELD_DATA
                                : VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  this->Mapper->SelectScalarArray(selection.Array->GetName());
  this->Mapper->SetVectorMode(selection.Component < 0 ? vtkTetMarchVolumeMapper::MAGNITUDE
                                                      : vtkTetMarchVolumeMapper::COMPONENT);
  this->Mapper->SetVectorComponent(std::max(selection.Component, 0));
  this->Mapper->SetOpacityLaw(commandLine.StructuredOpacityLaw
                                ? vtkTetMarchVolumeMapper::STRUCTURED
                                : vtkTetMarchVolumeMapper::UNSTRUCTURED);
  this->Mapper->SetAccuracyLevel(commandLine.AccuracyLevel);
  if (commandLine.Tolerance)
  {
    this->Mapper->SetErrorTolerance(*commandLine.Tolerance);
  }
  this->Mapper->SetFrameTimeBudget(commandLine.FrameTime);
  this->Mapper->SetErrorBudget(commandLine.Error);
  this->Mapper->SetBlendMode(commandLine.BlendMode);
  this->Mapper->SetViewMode(commandLine.ViewMode);
  SetUpCuts(commandLine.Cuts, this->Mapper);
  this->Legend->SetMapper(this->Mapper);

  this->Volume->SetMapper(this->Mapper);
  this->Volume->GetProperty()->SetColor(functions.Color);
  this->Volume->GetProperty()->SetScalarOpacity(functions.Opacity);
  this->Volume->GetProperty()->SetScalarOpacityUnitDistance(unitDistance);
  this->Volume->GetProperty()->SetInterpolationTypeToLinear();
  vtkContourValues* surfaces = this->Volume->GetProperty()->GetIsoSurfaceValues();
  surfaces->SetNumberOfContours(static_cast<int>(commandLine.IsoValues.size()));
  for (std::size_t i = 0; i < commandLine.IsoValues.size(); ++i)
  {
    surfaces->SetValue(static_cast<int>(i), commandLine.IsoValues[i]);
  }

  if (!commandLine.NanColor.empty())
  {
    const std::vector<double>& rgba = commandLine.NanColor;
    functions.Color->SetNanColorRGBA(rgba[0], rgba[1], rgba[2], rgba[3]);
    this->Mapper->DrawNanCellsOn();
  }

  const auto& background = commandLine.Background;
  this->Renderer->SetBackground(background[0], background[1], background[2]);
  this->Renderer->AddVolume(this->Volume);
  this->Renderer->AddViewProp(this->Legend);
  for (const std::string& path : commandLine.Surfaces)
  {
    this->AddSurface(path);
  }
  this->Window->AddRenderer(this->Renderer);
  SetUpLight(commandLine.Light, this->Renderer, this->Volume->GetProperty(), this->Mapper);
  this->PlaceCamera(commandLine);
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

void Picture::PlaceCamera(const CommandLine& commandLine)
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
    PlaceDefaultCamera(camera, this->Mapper->GetBounds(), aspect);
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
    ProgressBar progress("rendering", this->Mapper);
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
  double tolerance = this->Mapper->GetUsedErrorTolerance();
  for (int same = 0, i = 0; same < longEnough && i < most; ++i)
  {
    this->Render();
    same = this->Mapper->GetUsedErrorTolerance() == tolerance ? same + 1 : 0;
    tolerance = this->Mapper->GetUsedErrorTolerance();
  }
}

void Picture::Compare()
{
  this->Mapper->CollectDiagnosticsOn();
  this->Render();
  if (!this->Mapper->CompareWithGroundTruth(this->Volume))
  {
    throw Failure("the picture could not be compared");
  }
}

void Picture::Trace(const std::array<int, 2>& pixel, PixelTrace& trace)
{
  this->Mapper->CollectDiagnosticsOn();
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
    { std::pair<int, vtkTable*>{ vtkTetMarchVolumeMapper::TRACE_FLOAT, trace.Float },
      { vtkTetMarchVolumeMapper::TRACE_DOUBLE, trace.Double },
      { vtkTetMarchVolumeMapper::TRACE_GROUND_TRUTH, trace.GroundTruth } })
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
