// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Random rays through images wherever these are
 */
#ifndef tetmarch_testing_SelfTestPlacedRay_h
#define tetmarch_testing_SelfTestPlacedRay_h

#include "ClosedForms.h"
#include "LatticeTruth.h"
#include "SelfTestModels.h"

#include "vtkImageData.h"

namespace tetmarch::testing
{
constexpr LatticeValues AllValues[] = { LatticeValues::PointsLinear, LatticeValues::PointsNearest,
  LatticeValues::CellsLinear, LatticeValues::CellsNearest };

inline Vec3 along(const Vec3& origin, const Vec3& direction, double t)
{
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  Vec3 point;
  for (int a = 0; a < 3; ++a)
  {
    point[a] = origin[a] + t / length * direction[a];
  }
  return point;
}

/// A line by a point of the unit cube and a direction, and where these are in an image that the
/// cube is stretched over.
struct PlacedRay
{
  Vec3 Origin;
  Vec3 Direction;
  Vec3 CubeOrigin;
  Vec3 CubeDirection;
  double T0 = 0.0; ///< where it enters and leaves the volume
  double T1 = 0.0;

  /// In the unit cube.
  Vec3 at(double t) const
  {
    const double length = std::hypot(this->Direction[0], this->Direction[1], this->Direction[2]);
    Vec3 point;
    for (int a = 0; a < 3; ++a)
    {
      point[a] = this->CubeOrigin[a] + t / length * this->CubeDirection[a];
    }
    return point;
  }
};

inline PlacedRay placedRay(vtkImageData* image, std::mt19937& generator)
{
  PlacedRay ray;
  ray.CubeOrigin = randomPoint(generator, 0.0, 1.0);
  ray.CubeDirection = randomDirection(generator);
  const Vec3 through = along(ray.CubeOrigin, ray.CubeDirection, 1.0);
  Vec3 ends[2];
  for (int end = 0; end < 2; ++end)
  {
    const Vec3& p = end == 0 ? ray.CubeOrigin : through;
    const int* extent = image->GetExtent();
    double index[3];
    for (int a = 0; a < 3; ++a)
    {
      index[a] = extent[2 * a] + p[a] * (extent[2 * a + 1] - extent[2 * a]);
    }
    image->TransformContinuousIndexToPhysicalPoint(index, ends[end].data());
  }
  ray.Origin = ends[0];
  for (int a = 0; a < 3; ++a)
  {
    ray.Direction[a] = ends[1][a] - ends[0][a];
    ray.CubeDirection[a] = through[a] - ray.CubeOrigin[a];
  }
  const double scale = std::hypot(ray.Direction[0], ray.Direction[1], ray.Direction[2]);
  const Vec3 back = { -ray.CubeDirection[0], -ray.CubeDirection[1], -ray.CubeDirection[2] };
  ray.T0 = -scale * boxChord(ray.CubeOrigin, back, { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 0.0);
  ray.T1 =
    scale * boxChord(ray.CubeOrigin, ray.CubeDirection, { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 0.0);
  return ray;
}
} // namespace tetmarch::testing

#endif
