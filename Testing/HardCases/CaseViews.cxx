// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CaseViews.h"

#include "vtkCamera.h"
#include "vtkMath.h"

#include <cmath>

namespace tetmarch::testing
{
namespace
{
Vec3 along(const Vec3& from, const Vec3& direction, double length)
{
  const double norm = std::hypot(direction[0], direction[1], direction[2]);
  Vec3 p;
  for (int a = 0; a < 3; ++a)
  {
    p[a] = from[a] + length * (direction[a] / norm);
  }
  return p;
}

struct Framing
{
  Vec3 Centre;
  double HalfDiagonal;
};

Framing framing(const Box& box)
{
  Framing result;
  double squares = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    result.Centre[a] = box.Low[a] + 0.5 * (box.High[a] - box.Low[a]);
    squares += (box.High[a] - box.Low[a]) * (box.High[a] - box.Low[a]);
  }
  result.HalfDiagonal = 0.5 * std::sqrt(squares);
  return result;
}

void place(vtkCamera* camera, const Vec3& position, const Vec3& focalPoint, const Vec3& up)
{
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focalPoint.data());
  camera->SetViewUp(up.data());
}

const Vec3 ObliqueDirection = { -0.55, -0.4, -0.75 };
const Vec3 ObliqueUp = { 0.1, 1.0, 0.0 };
} // namespace

Box boundsOf(vtkUnstructuredGrid* grid)
{
  double b[6];
  grid->GetBounds(b);
  return { { b[0], b[2], b[4] }, { b[1], b[3], b[5] } };
}

HardView parallelView(const std::string& name, const Vec3& direction, const Vec3& up,
  double partOfDiagonal, const Bounds& bounds)
{
  HardView view;
  view.Name = name;
  view.Set = [=](vtkCamera* camera, vtkUnstructuredGrid* grid)
  {
    const Framing frame = framing(bounds(grid));
    place(camera, along(frame.Centre, direction, -4.0 * frame.HalfDiagonal), frame.Centre, up);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(partOfDiagonal * frame.HalfDiagonal);
  };
  return view;
}

HardView perspectiveView(const std::string& name, const Vec3& direction, const Vec3& up,
  double angle, const Bounds& bounds)
{
  HardView view;
  view.Name = name;
  view.Set = [=](vtkCamera* camera, vtkUnstructuredGrid* grid)
  {
    const Framing frame = framing(bounds(grid));
    const double distance =
      0.9 * frame.HalfDiagonal / std::tan(0.5 * vtkMath::RadiansFromDegrees(angle));
    place(camera, along(frame.Centre, direction, -distance), frame.Centre, up);
    camera->ParallelProjectionOff();
    camera->SetViewAngle(angle);
  };
  return view;
}

std::vector<HardView> standardViewsOf(const Bounds& bounds)
{
  return { perspectiveView("oblique", ObliqueDirection, ObliqueUp, 30.0, bounds),
    parallelView("along-z", { 0, 0, -1 }, { 0, 1, 0 }, 0.9, bounds),
    parallelView("along-diagonal", { -1, -1, -1 }, { 0, 0, 1 }, 1.0, bounds) };
}

std::vector<HardView> standardViews() { return standardViewsOf(boundsOf); }

HardView viewOnPixels(const std::string& name, int pixels, const Vec3& through, const Vec3& right,
  const Vec3& up, double spacing)
{
  HardView view;
  view.Name = name;
  view.Pixels = pixels;
  view.Set = [=](vtkCamera* camera, vtkUnstructuredGrid*)
  {
    const double shift = pixels % 2 == 0 ? 0.5 * spacing : 0.0;
    const Vec3 middle = along(along(through, right, shift), up, shift);
    const Vec3 backwards = { right[1] * up[2] - right[2] * up[1],
      right[2] * up[0] - right[0] * up[2], right[0] * up[1] - right[1] * up[0] };
    place(camera, along(middle, backwards, 4.0), middle, up);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5 * pixels * spacing);
  };
  return view;
}

HardView viewFrom(const std::string& name, const std::function<Vec3(vtkUnstructuredGrid*)>& eye,
  const Vec3& direction, const Vec3& up, double angle)
{
  HardView view;
  view.Name = name;
  view.Set = [=](vtkCamera* camera, vtkUnstructuredGrid* grid)
  {
    const Vec3 position = eye(grid);
    place(camera, position, along(position, direction, 1.0), up);
    camera->ParallelProjectionOff();
    camera->SetViewAngle(angle);
  };
  return view;
}

HardView inSmallWindow(const HardView& view, int pixels)
{
  HardView small = view;
  small.Pixels = view.Pixels > 0 ? pixels - (view.Pixels - pixels) % 2 : pixels;
  if (view.Pixels > 0)
  {
    small.Set = [large = view, side = small.Pixels](vtkCamera* camera, vtkUnstructuredGrid* grid)
    {
      large.Set(camera, grid);
      camera->SetParallelScale(side * camera->GetParallelScale() / large.Pixels);
      const double half = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
      camera->SetViewAngle(
        2.0 * vtkMath::DegreesFromRadians(std::atan(side * half / large.Pixels)));
    };
  }
  return small;
}
} // namespace tetmarch::testing
