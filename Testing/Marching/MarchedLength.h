// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How much of a ray the march integrates: the sum of its segments
 */
#ifndef tetmarch_testing_MarchedLength_h
#define tetmarch_testing_MarchedLength_h

#include "Reference/Kernel.h"

#include "GroundTruth.h"
#include "MarchedMesh.h"

#include <cmath>
#include <limits>

namespace tetmarch::testing
{
struct Marched
{
  double Length = 0.0; ///< or the integral of the colour
  int Cells = 0;
  int Refused = 0;
  int Lost = 0;
  int Guarded = 0;
};

/// Marches with so little extinction that the transmittance stays exactly 1: the colour is then the
/// plain sum of the segments, with the rounding of that sum and nothing else.
template <typename Kernel, typename Real>
class LengthMarcher
{
public:
  explicit LengthMarcher(const TetMesh& mesh, const IntegralTable& table = whiteTable())
    : March(kernelOf<Kernel, Real>(mesh, table))
  {
  }

  Marched march(
    const typename Kernel::Ray& ray, Real depthBegin = Real(-3e38f), Real depthEnd = Real(3e38f))
  {
    const Real unit = std::ldexp(Real(1), -std::numeric_limits<Real>::digits - 8);
    const auto result = this->March.castPlainRay(ray, unit, depthBegin, depthEnd);
    return { double(result.radiance.color.x) / double(unit), result.cells, result.refused,
      result.lost, result.guarded };
  }

  Kernel March;
};

/// White of extinction 1.
inline OpticalModel constantModel()
{
  return opticalModelOf({ { { 0.0, 1.0, 1.0, 1.0 } } }, { { { 0.0, 1.0 } } });
}
} // namespace tetmarch::testing

#endif
