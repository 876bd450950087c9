// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Rays through lattices, and hard fields and functions for them
 */
#ifndef tetmarch_testing_LatticeParts_h
#define tetmarch_testing_LatticeParts_h

#include "LatticeGrids.h"
#include "LatticeTruth.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <cmath>
#include <random>

namespace tetmarch::testing
{
/// Part of a ray of the normalised frame.
struct LatticePart
{
  Vec3 Point{};
  Vec3 Direction{};
  double Begin = 0; ///< depths
  double End = 0;
  double UnitDistance = 1; ///< in units of the frame

  double perDepth() const { return 1 / this->UnitDistance; }
  /// The depth of the point.
  double offset() const
  {
    const Vec3 &p = this->Point, &d = this->Direction;
    return p[0] * d[0] + p[1] * d[1] + p[2] * d[2];
  }
  template <typename Kernel>
  typename Kernel::Ray of(Kernel& kernel) const
  {
    using Real = decltype(kernel.tableScale);
    const Vec3 &p = this->Point, &d = this->Direction;
    return kernel.rayThrough(
      { Real(p[0]), Real(p[1]), Real(p[2]) }, { Real(d[0]), Real(d[1]), Real(d[2]) });
  }
};

/// Of generic directions every second one; the others are along axes or in planes of cells.
inline Vec3 randomDirection(std::mt19937& random)
{
  Vec3 d{ 0.0, 0.0, 0.0 };
  const unsigned kind = random() % 4;
  for (int k = 0; k < 3; ++k)
  {
    d[k] = kind < 2    ? 2.0 * uniform(random) - 1.0
           : kind == 2 ? double(random() % 3) - 1.0
                       : (random() % 2 ? 2.0 * uniform(random) - 1.0 : 0.0);
  }
  const double length = std::hypot(d[0], d[1], d[2]);
  return length < 1e-3 ? Vec3{ 0.0, 0.0, 1.0 }
                       : Vec3{ d[0] / length, d[1] / length, d[2] / length };
}

/// Red rises, blue has a peak; the opacity is a ramp with a narrow peak.
inline OpticalModel rampAndPeak(double unitDistance)
{
  OpticalModel model = opticalModelOf({ { { 0.0, 0.1, 0.9, 0.0 } }, { { 0.45, 0.2, 0.3, 0.1 } },
                                        { { 0.5, 0.9, 0.1, 0.9 } }, { { 1.0, 1.0, 0.2, 0.3 } } },
    { { { 0.0, 0.0 } }, { { 0.4, 0.2 } }, { { 0.48, 0.1 } }, { { 0.5, 0.9 } }, { { 0.52, 0.1 } },
      { { 1.0, 0.6 } } });
  model.UnitDistance = unitDistance;
  return model;
}
} // namespace tetmarch::testing

#endif
