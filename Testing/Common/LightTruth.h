// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Light that comes to a point through a volume, and what a ray sees of it, by brute force
 *
 * Like GroundTruth.h and LatticeTruth.h it has nothing in common with the march: each transmittance
 * is that of a line through all cells, and each point of a ray at which the quadrature asks has its
 * own. The volume scatters evenly in all directions.
 */
#ifndef tetmarch_testing_LightTruth_h
#define tetmarch_testing_LightTruth_h

#include "GroundTruth.h"
#include "LatticeTruth.h"

#include <functional>

namespace tetmarch::testing
{
/// A unit vector to the light, 0; or its position, 1.
using LightPlace = std::array<double, 4>;

class LightTruth
{
public:
  using Brightness = std::function<double(const Vec3&)>;

  /// Of a GroundTruthScene or a LatticeTruth, which is referred to, not copied.
  template <typename Scene>
  explicit LightTruth(const Scene& scene)
    : Depth([&scene](const Vec3& point, const Vec3& direction, double end)
        { return scene.depth(point, direction, 0.0, end); })
    , Seen([&scene](const Vec3& origin, const Vec3& direction, const Brightness& brightness,
             double tolerance)
        { return scene.integrateLit(origin, direction, brightness, tolerance); })
  {
  }

  /// From a point to a light, at most as far as the reach.
  double transmittance(
    const Vec3& point, const LightPlace& light, double reach = GroundTruthScene::Infinity) const;

  /// The mean over all directions up to a radius: light from around. By Gauss-Legendre quadrature
  /// over the height on the sphere, and as many points around it as make it exact for polynomials
  /// of the same degree.
  double ambient(const Vec3& point, double radius, int heights) const;

  /// Premultiplied RGBA of what a ray sees from its origin on where one light of strength 1 shines,
  /// to the tolerance for each chord.
  std::array<double, 4> seen(const Vec3& origin, const Vec3& direction, const LightPlace& light,
    double tolerance = 1e-7) const;
  /// The same where that brightness multiplies the colour of each point.
  std::array<double, 4> seen(const Vec3& origin, const Vec3& direction,
    const Brightness& brightness, double tolerance = 1e-7) const
  {
    return this->Seen(origin, direction, brightness, tolerance);
  }

private:
  std::function<double(const Vec3& point, const Vec3& direction, double end)> Depth;
  std::function<std::array<double, 4>(
    const Vec3& origin, const Vec3& direction, const Brightness& brightness, double tolerance)>
    Seen;
};
} // namespace tetmarch::testing

#endif
