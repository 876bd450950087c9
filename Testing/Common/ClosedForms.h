// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Answers in closed form: what a ray sees in simple cases
 */
#ifndef tetmarch_testing_ClosedForms_h
#define tetmarch_testing_ClosedForms_h

#include "GridBuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch::testing
{
/// Opacity of constant extinction kappa over a length: 1 - exp(-kappa L).
inline double slabOpacity(double kappa, double length) { return -std::expm1(-kappa * length); }

/// Opacity of an extinction that goes linearly from kappa0 to kappa1 over a length.
inline double rampOpacity(double kappa0, double kappa1, double length)
{
  return -std::expm1(-0.5 * (kappa0 + kappa1) * length);
}

/// Colour of constant extinction kappa over a length on which the emitted colour goes linearly from
/// c0 (near) to c1: c0 (1 - e^-D) + (c1 - c0) (1 - (1 + D) e^-D) / D with D = kappa L > 0.
inline double slabColour(double c0, double c1, double kappa, double length)
{
  const double depth = kappa * length;
  return c0 * -std::expm1(-depth) +
         (c1 - c0) * (-std::expm1(-depth) - depth * std::exp(-depth)) / depth;
}

/// Length of a line inside an axis-aligned box, whole or from the origin on (tMin = 0).
inline double boxChord(const Vec3& origin, const Vec3& direction, const Vec3& low, const Vec3& high,
  double tMin = -std::numeric_limits<double>::infinity())
{
  double t0 = tMin;
  double t1 = std::numeric_limits<double>::infinity();
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  for (int a = 0; a < 3; ++a)
  {
    if (direction[a] == 0.0)
    {
      if (origin[a] < low[a] || origin[a] > high[a])
      {
        return 0.0;
      }
      continue;
    }
    const double ta = (low[a] - origin[a]) / direction[a] * length;
    const double tb = (high[a] - origin[a]) / direction[a] * length;
    t0 = std::max(t0, std::min(ta, tb));
    t1 = std::min(t1, std::max(ta, tb));
  }
  return std::max(t1 - t0, 0.0);
}
} // namespace tetmarch::testing

#endif
