// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Annotations.h"

#include "AnnotationText.h"
#include "Messages.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkLookupTable.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{

namespace
{

/// What is drawn as large as in a picture of 1024 x 768, in a picture of this size.
double GetScale(const CommandLine& commandLine)
{
  const auto& [width, height] = commandLine.Size;
  return std::max(0.5, std::min(width / 1024.0, height / 768.0));
}

/// White on dark, black on bright; grey, which is legible on both, where it isn't known.
std::array<double, 3> GetForeground(const CommandLine& commandLine)
{
  if (commandLine.Transparent)
  {
    return { { 0.5, 0.5, 0.5 } };
  }
  const auto& [red, green, blue] = commandLine.Background;
  const double lightness = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  const double shade = lightness > 0.5 ? 0.0 : 1.0;
  return { { shade, shade, shade } };
}

void MakeSmallerUntilItFits(const std::string& text, int width, vtkTextProperty* property)
{
  constexpr int least = 6;
  while (property->GetFontSize() > least && MeasureText(text, property)[0] > width)
  {
    property->SetFontSize(property->GetFontSize() - 1);
  }
}

} // namespace

double GetScalarBarShare(const CommandLine& commandLine)
{
  constexpr double pixels = 150.0; // of a picture of 1024 x 768
  return commandLine.Annotations.ScalarBar
           ? std::min(0.4, pixels * GetScale(commandLine) / commandLine.Size[0])
           : 0.0;
}

Annotations::Annotations(const CommandLine& commandLine, vtkRenderer* renderer)
  : Options(commandLine)
  , Renderer(renderer)
{
  if (commandLine.Annotations.Outline)
  {
    this->AddOutline();
  }
  if (commandLine.Annotations.Axes)
  {
    this->Axes = std::make_unique<BoxAxes>(
      commandLine.Size, GetScale(commandLine), GetForeground(commandLine));
    this->Axes->AddTo(renderer);
  }
}

void Annotations::AddOutline()
{
  vtkNew<vtkCellArray> edges;
  for (vtkIdType from = 0; from < 8; ++from)
  {
    for (const vtkIdType along : { 1, 2, 4 })
    {
      if ((from & along) == 0)
      {
        edges->InsertNextCell({ from, from | along });
      }
    }
  }
  this->Outline->SetLines(edges);

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(this->Outline);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  std::array<double, 3> color = GetForeground(this->Options);
  actor->GetProperty()->SetColor(color.data());
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(static_cast<float>(1.5 * GetScale(this->Options)));
  this->Renderer->AddActor(actor);
}

void Annotations::SetBounds(const std::array<double, 6>& bounds)
{
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  for (int corner = 0; corner < 8; ++corner)
  {
    corners->InsertNextPoint(
      bounds[corner & 1 ? 1 : 0], bounds[corner & 2 ? 3 : 2], bounds[corner & 4 ? 5 : 4]);
  }
  this->Outline->SetPoints(corners);
  this->Bounds = bounds;
}

void Annotations::FollowCamera()
{
  if (this->Axes && !this->Axes->Place(this->Bounds, this->Renderer->GetActiveCamera()))
  {
    PrintMessage("warning",
      "there are no axes, since some of the data's box is behind the camera, see --camera");
  }
}

void Annotations::AddScalarBar(
  vtkColorTransferFunction* colors, const std::array<double, 2>& range, const std::string& title)
{
  constexpr int steps = 256;
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(steps);
  table->SetTableRange(range[0], range[1]);
  for (int i = 0; i < steps; ++i)
  {
    double rgb[3];
    colors->GetColor(range[0] + (range[1] - range[0]) * i / (steps - 1), rgb);
    table->SetTableValue(i, rgb[0], rgb[1], rgb[2]);
  }

  const double share = GetScalarBarShare(this->Options);
  const double scale = GetScale(this->Options);
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(table);
  bar->SetMaximumNumberOfColors(steps);
  bar->SetTitle(title.c_str());
  bar->SetLabelFormat("%.4g");
  bar->SetNumberOfLabels(5);
  bar->UnconstrainedFontSizeOn();
  bar->SetPosition(1.0 - share, 0.1);
  bar->SetWidth(0.9 * share);
  bar->SetHeight(0.8);
  bar->SetBarRatio(0.2);
  bar->SetVerticalTitleSeparation(static_cast<int>(10 * scale));
  bar->SetTextPad(static_cast<int>(4 * scale));
  const bool onPlate = this->Options.Transparent;
  const std::array<double, 3> white = { { 1.0, 1.0, 1.0 } };
  const std::array<double, 3> color = onPlate ? white : GetForeground(this->Options);
  SetUpText(bar->GetTitleTextProperty(), color, 18 * scale);
  SetUpText(bar->GetLabelTextProperty(), color, 16 * scale);
  MakeSmallerUntilItFits(
    title, static_cast<int>(0.9 * share * this->Options.Size[0]), bar->GetTitleTextProperty());
  if (onPlate)
  {
    bar->DrawBackgroundOn();
    bar->GetBackgroundProperty()->SetColor(0.1, 0.1, 0.1);
    bar->GetBackgroundProperty()->SetOpacity(0.7);
  }
  this->Renderer->AddActor2D(bar);
}

} // namespace tetmarch
