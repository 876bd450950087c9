// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Views.h"

#include "vtkCamera.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
namespace
{
Vec3 unit(const Vec3& v)
{
  const double length = std::hypot(v[0], v[1], v[2]);
  return { v[0] / length, v[1] / length, v[2] / length };
}

// The axis most across the direction.
Vec3 upFor(const Vec3& direction)
{
  const int least =
    static_cast<int>(std::min_element(direction.begin(), direction.end(),
                       [](double a, double b) { return std::abs(a) < std::abs(b); }) -
                     direction.begin());
  Vec3 up{ 0.0, 0.0, 0.0 };
  up[least] = 1.0;
  return up;
}

void look(vtkCamera* camera, const Vec3& eye, const Vec3& focus, const Vec3& up)
{
  camera->SetPosition(eye[0], eye[1], eye[2]);
  camera->SetFocalPoint(focus[0], focus[1], focus[2]);
  camera->SetViewUp(up[0], up[1], up[2]);
}

Vec3 along(const Vec3& from, const Vec3& direction, double distance)
{
  return { from[0] + distance * direction[0], from[1] + distance * direction[1],
    from[2] + distance * direction[2] };
}
} // namespace

Ball ballOf(vtkUnstructuredGrid* grid)
{
  double b[6];
  grid->GetBounds(b);
  const double radius = 0.5 * std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  return { { 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]) },
    radius > 0.0 ? radius : 1.0 };
}

HardView perspectiveFrom(
  const std::string& name, const Vec3& direction, double radiiAway, double share)
{
  const double angle = 2.0 * vtkMath::DegreesFromRadians(std::asin(1.0 / share / radiiAway));
  return perspectiveOfAngle(name, direction, radiiAway, angle);
}

HardView perspectiveOfAngle(
  const std::string& name, const Vec3& direction, double radiiAway, double angle)
{
  return { name, [=](vtkCamera* camera, vtkUnstructuredGrid* grid)
    {
      const Ball ball = ballOf(grid);
      look(camera, along(ball.Centre, unit(direction), radiiAway * ball.Radius), ball.Centre,
        upFor(direction));
      camera->SetViewAngle(angle);
    } };
}

HardView parallelAlong(const std::string& name, const Vec3& direction, double scale)
{
  return { name, [=](vtkCamera* camera, vtkUnstructuredGrid* grid)
    {
      const Ball ball = ballOf(grid);
      look(camera, along(ball.Centre, unit(direction), 4.0 * ball.Radius), ball.Centre,
        upFor(direction));
      camera->ParallelProjectionOn();
      camera->SetParallelScale(scale * ball.Radius);
    } };
}

HardView eyeAt(const std::string& name, const Vec3& eye, const Vec3& direction)
{
  return { name,
    [=](vtkCamera* camera, vtkUnstructuredGrid* grid)
    {
      const double radius = ballOf(grid).Radius;
      look(camera, eye, along(eye, unit(direction), radius), upFor(direction));
      camera->SetViewAngle(60.0);
      camera->SetClippingRange(1e-3 * radius, 10.0 * radius);
    },
    true };
}
} // namespace tetmarch::testing
