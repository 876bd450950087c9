// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/CameraFit.h"

#include "vtkCamera.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{

namespace
{

using Limits = std::numeric_limits<double>;

// The smallest interval that contains all added values.
struct Interval
{
  double Least = Limits::max();
  double Most = Limits::lowest();

  void put(double value)
  {
    this->Least = std::min(this->Least, value);
    this->Most = std::max(this->Most, value);
  }
  double centre() const { return 0.5 * (this->Least + this->Most); }
  double half() const { return 0.5 * (this->Most - this->Least); }
};

// A side of the view's pyramid contains the outermost point: with z towards the viewer, who is at z
// = d over the centre c, a point is within the picture if |x - c| <= slope (d - z). With the maxima
// of x + slope z and of -x + slope z, d is half of their sum divided by the slope, c half of their
// difference.
struct Pyramid
{
  double Slope;
  double High = Limits::lowest(); // of x + slope z
  double Low = Limits::lowest();  // of -x + slope z

  void put(double x, double z)
  {
    this->High = std::max(this->High, x + this->Slope * z);
    this->Low = std::max(this->Low, -x + this->Slope * z);
  }
  double centre() const { return 0.5 * (this->High - this->Low); }
  double distance() const { return 0.5 * (this->High + this->Low) / this->Slope; }
};

Vector3 at(const PicturePlane& plane, double x, double y, double z)
{
  Vector3 point{};
  add(x, plane.Right, point);
  add(y, plane.Up, point);
  add(z, plane.Back, point);
  return point;
}

} // namespace

void fitCamera(const std::vector<Vector3>& points, const PicturePlane& plane, double aspect,
  vtkCamera* camera, double room)
{
  constexpr double angle = 30.0;
  const double slope = std::tan(vtkMath::RadiansFromDegrees(0.5 * angle)) * room;
  Pyramid across{ slope * aspect };
  Pyramid upwards{ slope };
  Interval xs;
  Interval ys;
  Interval zs;
  for (const Vector3& point : points)
  {
    const double x = dot(point, plane.Right);
    const double y = dot(point, plane.Up);
    const double z = dot(point, plane.Back);
    across.put(x, z);
    upwards.put(y, z);
    xs.put(x);
    ys.put(y);
    zs.put(z);
  }
  const bool any = !points.empty();
  const double size = any ? std::max({ xs.half(), ys.half(), zs.half() }) : 0.0;
  if (!(size > 0.0))
  {
    const Vector3 place = any ? points[0] : Vector3{};
    across = { slope * aspect };
    upwards = { slope };
    across.put(dot(place, plane.Right), dot(place, plane.Back) + 1.0);
    upwards.put(dot(place, plane.Up), dot(place, plane.Back) + 1.0);
    zs.put(dot(place, plane.Back));
  }
  const double x = across.centre();
  const double y = upwards.centre();
  const double depth = zs.centre();
  const double nearest = zs.Most + (size > 0.0 ? 1e-3 * size : 1.0);
  const double distance = std::max({ across.distance(), upwards.distance(), nearest });
  const double halfWidth = any ? std::max(xs.Most - x, x - xs.Least) : 0.0;
  const double halfHeight = any ? std::max(ys.Most - y, y - ys.Least) : 0.0;
  const double scale = std::max(halfHeight, halfWidth / aspect) / room;

  camera->SetFocalPoint(at(plane, x, y, depth).data());
  camera->SetPosition(at(plane, x, y, distance).data());
  camera->SetViewUp(plane.Up.data());
  camera->SetViewAngle(angle);
  camera->SetParallelScale(scale > 0.0 ? scale : 1.0);
}

bool isTooNear(const std::vector<Vector3>& points, vtkCamera* camera)
{
  // vtkCamera::SetClippingRange() moves a nearer plane to 1e-20; ResetCameraClippingRange() of a
  // renderer makes 1.7e-20 of that.
  constexpr double NearestPlane = 1.7e-20;
  Vector3 eye;
  camera->GetPosition(eye.data());
  return !points.empty() && std::all_of(points.begin(), points.end(),
                              [&eye](const Vector3& point)
                              {
                                const Vector3 sight = point - eye;
                                return std::hypot(sight[0], sight[1], sight[2]) < NearestPlane;
                              });
}

} // namespace tetmarch
