// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/ClippedBox.h"

#include "Geometry/Vector3.h"
#include "View/Clipping.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

using Plane = std::array<double, 4>; // as in Clipping::Planes

// Tolerance relative to the unit ball of the volume: points farther outside a plane are outside.
constexpr double Touching = 1e-9;

double heightOver(const Plane& plane, const Vector3& point)
{
  return plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] + plane[3];
}

Vector3 normalOf(const Plane& plane) { return { { plane[0], plane[1], plane[2] } }; }

// Set the intersection point of three planes. False if it is not unique.
bool intersect(const Plane& a, const Plane& b, const Plane& c, Vector3& point)
{
  const Vector3 bc = cross(normalOf(b), normalOf(c));
  const double determinant = dot(normalOf(a), bc);
  point.fill(0);
  add(-a[3], bc, point);
  add(-b[3], cross(normalOf(c), normalOf(a)), point);
  add(-c[3], cross(normalOf(a), normalOf(b)), point);
  point = scaled(1 / determinant, point);
  return std::abs(determinant) > 1e-12;
}

// Whether the half-spaces, six of which bound a box, have a common point. If so, an intersection
// point of three planes is one.
bool haveCommonPoint(const std::vector<Plane>& planes)
{
  const auto contain = [&planes](const Vector3& point)
  {
    return std::all_of(planes.begin(), planes.end(),
      [&point](const Plane& plane) { return heightOver(plane, point) >= -Touching; });
  };
  for (std::size_t a = 0; a < planes.size(); ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      for (std::size_t c = 0; c < b; ++c)
      {
        Vector3 point;
        if (intersect(planes[a], planes[b], planes[c], point) && contain(point))
        {
          return true;
        }
      }
    }
  }
  return false;
}

bool leavesSomething(std::vector<Plane> planes, const Vector3& low, const Vector3& high)
{
  for (int k = 0; k < 3; ++k)
  {
    Plane plane{};
    plane[k] = 1;
    plane[3] = -low[k];
    planes.push_back(plane);
    plane[k] = -1;
    plane[3] = high[k];
    planes.push_back(plane);
  }
  return haveCommonPoint(planes);
}

} // namespace

bool leavesNothing(const Clipping& clipping, const std::array<double, 3>& halfExtent)
{
  if (clipping.LeavesNothing || !clipping.cuts())
  {
    return clipping.LeavesNothing;
  }
  for (int region = 0; region < 27; ++region)
  {
    if (!(clipping.CroppingFlags >> region & 1))
    {
      continue;
    }
    const int at[3] = { region % 3, region / 3 % 3, region / 9 };
    Vector3 low, high;
    for (int k = 0; k < 3; ++k)
    {
      const double planes[4] = { -halfExtent[k], clipping.CroppingLow[k], clipping.CroppingHigh[k],
        halfExtent[k] };
      low[k] = std::max(planes[0], planes[at[k]]);
      high[k] = std::min(planes[3], planes[at[k] + 1]);
    }
    if (leavesSomething(clipping.Planes, low, high))
    {
      return false;
    }
  }
  return true;
}

} // namespace tetmarch
