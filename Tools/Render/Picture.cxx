// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "Choice.h"
#include "DatasetReader.h"
#include "Failure.h"
#include "Framing.h"
#include "Messages.h"
#include "OffscreenWindow.h"
#include "OptionChecks.h"
#include "Outputs.h"
#include "PngFile.h"
#include "ProgressBar.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkAutoInit.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTetMarchFirstPicture.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

// The text of the legend and of what is beside the volume.
VTK_MODULE_INIT(vtkRenderingFreeType);

namespace tetmarch
{

Picture::Picture(const VolumeData& data, const double bounds[6], vtkTetMarchFirstPicture* choice,
  const CommandLine& commandLine)
  : Options(commandLine)
  , Pieces(commandLine.Size, GetLargestTile(commandLine))
  , Mapper(MakeMapper(data.Structured))
{
  CheckOptionsOfData(commandLine, data);
  this->SetUpWindow();
  this->Mapper->SetSettings(commandLine.Settings);
  this->Volume->SetMapper(this->Mapper->GetMapper());
  choice->ApplyTo(this->Volume);
  this->SetUpMapper();
  this->SetUpProperty();
  this->Legend->SetMapper(this->Mapper->GetMapper());
  this->Renderer->AddVolume(this->Volume);
  this->Renderer->AddViewProp(this->Legend);
  for (const std::string& path : commandLine.Surfaces)
  {
    this->AddSurface(path);
  }
  SetUpLight(commandLine.Light, this->Renderer, this->Volume->GetProperty());
  PlaceCamera(commandLine, choice, bounds, this->Renderer->GetActiveCamera());
  this->Beside = std::make_unique<Annotations>(commandLine, this->Renderer);
  if (commandLine.Annotations.ScalarBar)
  {
    this->Beside->AddScalarBar(
      choice->GetColor(), GetColorRange(choice, commandLine), GetTitle(choice));
  }
  this->SetData(data);
}

void Picture::SetUpWindow()
{
  const auto& [width, height] = this->Pieces.GetTileSize();
  std::string error;
  this->Window = MakeOffscreenWindow(width, height, &error);
  if (!this->Window)
  {
    throw Failure("no offscreen OpenGL: " + error);
  }
  this->Window->SetAlphaBitPlanes(this->Options.Transparent);
  this->Window->AddRenderer(this->Renderer);
  this->Pieces.SetUp(this->Window, this->Renderer);
  std::array<double, 3> background = this->Options.Background;
  if (this->Options.Transparent)
  {
    background = {};
  }
  this->Renderer->SetBackground(background.data());
  this->Renderer->SetBackgroundAlpha(this->Options.Transparent ? 0.0 : 1.0);
}

void Picture::SetData(const VolumeData& data)
{
  this->Mapper->SetInput(data.GetMapperInput());
  this->Beside->SetBounds(GetBounds(data));
  this->Renderer->ResetCameraClippingRange();
}

void Picture::Turn(double degrees)
{
  this->Renderer->GetActiveCamera()->Azimuth(degrees);
  this->Renderer->ResetCameraClippingRange();
}

void Picture::SetUpMapper()
{
  const CommandLine& commandLine = this->Options;
  this->Mapper->SetBlendMode(commandLine.BlendMode);
  SetUpCuts(commandLine.Cuts, *this->Mapper);

  if (commandLine.Settings->GetAccuracyLevel() == vtkTetMarchSettings::SAMPLED)
  {
    this->Mapper->SetSamples(commandLine.SampleDistance.value_or(-1.0), commandLine.Jitter);
  }
}

void Picture::SetUpProperty()
{
  const CommandLine& commandLine = this->Options;
  vtkVolumeProperty* property = this->Volume->GetProperty();
  if (!commandLine.NanColor.empty())
  {
    const std::vector<double>& rgba = commandLine.NanColor;
    property->GetRGBTransferFunction()->SetNanColorRGBA(rgba[0], rgba[1], rgba[2], rgba[3]);
  }
  property->SetInterpolationType(
    commandLine.Nearest.value_or(false) ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
  if (!commandLine.GradientOpacity.empty())
  {
    vtkNew<vtkPiecewiseFunction> gradientOpacity;
    for (const std::array<double, 2>& point : commandLine.GradientOpacity)
    {
      gradientOpacity->AddPoint(point[0], point[1]);
    }
    property->SetGradientOpacity(gradientOpacity);
  }
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

double Picture::Render()
{
  const int errorsBefore = Messages::GetNumberOfErrors();
  this->Beside->FollowCamera();
  const double begin = vtkTimerLog::GetUniversalTime();
  {
    ProgressBar progress("rendering", this->Mapper->GetMapper());
    if (this->Pieces.IsOne())
    {
      this->Window->Render();
    }
    else
    {
      this->Assembled = this->Pieces.Draw(this->Window, this->Renderer, this->Options.Transparent);
    }
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
  vtkTetMarchFrameStatistics* statistics = this->Mapper->GetStatistics();
  const auto used = [&]
  { return std::pair(statistics->GetUsedErrorTolerance(), statistics->GetUsedPixelTolerance()); };
  auto before = used();
  for (int same = 0, i = 0; same < longEnough && i < most; ++i)
  {
    this->Render();
    same = used() == before ? same + 1 : 0;
    before = used();
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

void Picture::Write(const std::string& name)
{
  const vtkSmartPointer<vtkImageData> picture =
    this->Pieces.IsOne() ? this->Pieces.Read(this->Window, this->Options.Transparent)
                         : this->Assembled;
  if (this->Options.Transparent)
  {
    DivideByOpacity(picture);
  }
  WriteOutput(name, GetBytes(EncodePng(picture)));
}

} // namespace tetmarch
