// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightTruth.h"

#include "GaussLegendre.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
double LightTruth::transmittance(const Vec3& point, const LightPlace& light, double reach) const
{
  Vec3 toLight;
  for (int a = 0; a < 3; ++a)
  {
    toLight[a] = light[a] - light[3] * point[a];
  }
  const double far = std::hypot(toLight[0], toLight[1], toLight[2]);
  const double end = light[3] > 0.0 ? std::min(far, reach) : reach;
  return far > 0.0 ? std::exp(-this->Depth(point, toLight, end)) : 1.0;
}

double LightTruth::ambient(const Vec3& point, double radius, int heights) const
{
  const GaussLegendre& q = GaussLegendre::instance();
  const int around = 2 * GaussLegendre::Order;
  double sum = 0.0;
  for (int part = 0; part < heights; ++part)
  {
    for (int i = 0; i < GaussLegendre::Order; ++i)
    {
      const double z = 2.0 * (part + q.Node[i]) / heights - 1.0;
      const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
      for (int k = 0; k < around; ++k)
      {
        const double turn = 2.0 * vtkMath::Pi() * (k + 0.5) / around;
        const double t =
          this->transmittance(point, { r * std::cos(turn), r * std::sin(turn), z, 0.0 }, radius);
        sum += q.Weight[i] / heights * t / around;
      }
    }
  }
  return sum;
}

std::array<double, 4> LightTruth::seen(
  const Vec3& origin, const Vec3& direction, const LightPlace& light, double tolerance) const
{
  return this->seen(
    origin, direction, [&](const Vec3& point) { return this->transmittance(point, light); },
    tolerance);
}
} // namespace tetmarch::testing
