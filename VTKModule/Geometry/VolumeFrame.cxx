// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/VolumeFrame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{
namespace
{

// The volume of a tetrahedron with edges of this length is a normal number in double precision.
constexpr double LeastRadius = 1e-100;

} // namespace

Vector3 VolumeFrame::toData(const Vector3& point) const
{
  Vector3 data;
  for (int k = 0; k < 3; ++k)
  {
    data[k] = this->Center[k] + this->Radius * point[k];
  }
  return data;
}

std::array<double, 16> VolumeFrame::matrixToData() const
{
  const double r = this->Radius;
  const Vector3& c = this->Center;
  return { { r, 0, 0, c[0], 0, r, 0, c[1], 0, 0, r, c[2], 0, 0, 0, 1 } };
}

std::string findFrame(const std::vector<Vector3>& points, VolumeFrame& frame)
{
  if (points.empty())
  {
    return {};
  }
  Vector3 low, high;
  low.fill(std::numeric_limits<double>::max());
  high.fill(std::numeric_limits<double>::lowest());
  for (const Vector3& point : points)
  {
    for (int k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  }
  return findFrame(low, high, frame);
}

std::string findFrame(const Vector3& low, const Vector3& high, VolumeFrame& frame)
{
  Vector3 half;
  for (int k = 0; k < 3; ++k)
  {
    frame.Center[k] = 0.5 * low[k] + 0.5 * high[k];
    // Measured from the rounded centre, which may differ from the middle of a box that is a few
    // roundings wide.
    half[k] = std::max(high[k] - frame.Center[k], frame.Center[k] - low[k]);
  }
  const double radius = std::hypot(half[0], half[1], half[2]);
  if (radius > 0 && radius < LeastRadius)
  {
    return "The points of the grid lie within less than 1e-100 of each other, which is too little "
           "for volumes in double precision. Scale them.";
  }
  frame.Radius = radius > 0 ? radius : 1;
  for (int k = 0; k < 3; ++k)
  {
    frame.HalfExtent[k] = half[k] / frame.Radius;
  }
  return {};
}

} // namespace tetmarch
