// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Annotations.h"

#include "Messages.h"
#include "ScalarBar.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>

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

/// Of the scalar bar, which has a dark plate if the background isn't known.
std::array<double, 3> GetTextColor(const CommandLine& commandLine)
{
  return commandLine.Transparent ? std::array<double, 3>{ { 1.0, 1.0, 1.0 } }
                                 : GetForeground(commandLine);
}

} // namespace

double GetWidthOfLabels(const CommandLine& commandLine) { return 70.0 * GetScale(commandLine); }

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
  , AxesOverlay(commandLine.Size, GetForeground(commandLine), 1.5 * GetScale(commandLine), renderer)
  , BarOverlay(commandLine.Size, GetTextColor(commandLine), 1.5 * GetScale(commandLine), renderer)
  , Axes(this->AxesOverlay, GetScale(commandLine))
{
  if (commandLine.Annotations.Outline)
  {
    this->AddOutline();
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
  if (this->Options.Annotations.Axes &&
      !this->Axes.Place(this->Bounds, this->Renderer->GetActiveCamera()))
  {
    PrintMessage("warning",
      "there are no axes, since some of the data's box is behind the camera, see --camera");
  }
}

void Annotations::AddScalarBar(
  vtkColorTransferFunction* colors, const std::array<double, 2>& range, const std::string& title)
{
  const ScalarBar bar{ title, colors, range, GetScalarBarShare(this->Options),
    GetScale(this->Options), this->Options.Transparent };
  bar.AddTo(this->BarOverlay);
}

} // namespace tetmarch
