// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Framing.h"

#include "Annotations.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkTetMarchFirstPicture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetmarch
{

namespace
{

/// The axis of the world that is nearest to a direction.
std::array<double, 3> FindNearestAxis(const double direction[3])
{
  int nearest = 0;
  for (int axis : { 1, 2 })
  {
    nearest = std::abs(direction[axis]) > std::abs(direction[nearest]) ? axis : nearest;
  }
  std::array<double, 3> along{};
  along[nearest] = direction[nearest] < 0.0 ? -1.0 : 1.0;
  return along;
}

std::array<double, 3> Subtract(const double a[3], const double b[3])
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

/// How far a camera at the end of a line of sight must be from its focal point, and which parallel
/// scale it needs, so that all that was put in is in view.
class Fit
{
public:
  Fit(vtkCamera* camera, double aspect)
    : Aspect(aspect)
    , Slope(std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle())))
  {
    camera->GetFocalPoint(this->Focus);
    camera->GetDirectionOfProjection(this->Away);
    vtkMath::Cross(this->Away, camera->GetViewUp(), this->Right);
    vtkMath::Normalize(this->Right);
    vtkMath::Cross(this->Right, this->Away, this->Up);
  }

  void Put(const double point[3])
  {
    const auto place = Subtract(point, this->Focus);
    const double across = std::abs(vtkMath::Dot(place.data(), this->Right)) / this->Aspect;
    const double upwards = std::abs(vtkMath::Dot(place.data(), this->Up));
    const double half = std::max(across, upwards);
    this->Scale = std::max(this->Scale, half);
    this->Distance =
      std::max(this->Distance, half / this->Slope - vtkMath::Dot(place.data(), this->Away));
  }

  double Distance = 0.0;
  double Scale = 0.0;

private:
  double Aspect;
  double Slope;
  double Focus[3], Away[3], Right[3], Up[3];
};

/// The box in view, looked at along the camera's line of sight; in views from all around, too.
void FitBox(const double bounds[6], double aspect, int views, vtkCamera* camera)
{
  const std::array<double, 3> center = { { 0.5 * (bounds[0] + bounds[1]),
    0.5 * (bounds[2] + bounds[3]), 0.5 * (bounds[4] + bounds[5]) } };
  double away[3];
  camera->GetDirectionOfProjection(away);
  const double reach = std::max(camera->GetDistance(), 1e-12);
  const auto standAt = [&](double distance)
  {
    camera->SetFocalPoint(center.data());
    camera->SetPosition(center[0] - distance * away[0], center[1] - distance * away[1],
      center[2] - distance * away[2]);
  };
  standAt(reach);
  double distance = 0.0;
  double scale = 0.0;
  for (int view = 0; view < views; ++view)
  {
    Fit fit(camera, aspect);
    for (int corner = 0; corner < 8; ++corner)
    {
      const double point[3] = { bounds[corner & 1 ? 1 : 0], bounds[corner & 2 ? 3 : 2],
        bounds[corner & 4 ? 5 : 4] };
      fit.Put(point);
    }
    distance = std::max(distance, fit.Distance);
    scale = std::max(scale, fit.Scale);
    camera->Azimuth(360.0 / views);
  }
  camera->GetDirectionOfProjection(away); // again the first, but for rounding
  standAt(distance > 0.0 ? distance : reach);
  camera->SetParallelScale(scale > 0.0 ? scale : 1.0);
}

/// What labels along two sides leave of the picture.
double GetShareWithinAxes(const CommandLine& commandLine)
{
  const double width = (1.0 - GetScalarBarShare(commandLine)) * commandLine.Size[0];
  const double shorter = std::min<double>(width, commandLine.Size[1]);
  return std::max(0.2, 1.0 - 2.0 * GetWidthOfLabels(commandLine) / shorter);
}

void ChooseCamera(const CommandLine& commandLine, vtkTetMarchFirstPicture* choice,
  const double bounds[6], vtkCamera* camera)
{
  const AnnotationOptions& shown = commandLine.Annotations;
  const double bar = GetScalarBarShare(commandLine);
  const double aspect = (1.0 - bar) * commandLine.Size[0] / commandLine.Size[1];
  choice->PlaceCamera(camera, aspect);
  if (commandLine.Turntable > 0)
  {
    camera->SetViewUp(FindNearestAxis(camera->GetViewUp()).data());
  }
  if (commandLine.Turntable > 0 || commandLine.Time || shown.Outline || shown.Axes)
  {
    const double room = shown.Axes ? GetShareWithinAxes(commandLine) : 0.95;
    FitBox(bounds, aspect, std::max(1, commandLine.Turntable), camera);
    camera->Dolly(room);
    camera->SetParallelScale(camera->GetParallelScale() / room);
  }
  camera->SetWindowCenter(bar, 0.0);
}

} // namespace

void PlaceCamera(const CommandLine& commandLine, vtkTetMarchFirstPicture* choice,
  const double bounds[6], vtkCamera* camera)
{
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
    ChooseCamera(commandLine, choice, bounds, camera);
  }
  if (commandLine.ParallelScale)
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(*commandLine.ParallelScale);
  }
}

} // namespace tetmarch
