// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far the colours that kernels see along rays are off, and whether their bounds hold
 */
#ifndef tetmarch_testing_ErrorTally_h
#define tetmarch_testing_ErrorTally_h

#include "ComponentRays.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace tetmarch::testing
{
/// The error of float, tables and quadrature, which no bound includes.
constexpr double Rounding = 2e-5;

struct ErrorTally
{
  int Rays = 0;
  double Worst = 0;       // error
  double BeyondBound = 0; // error less its bound
  double Bound = 0;       // sum
  double Error = 0;       // sum

  void add(const Rgba& seen, const Rgba& expected, double bound)
  {
    double error = 0;
    for (int k = 0; k < 4; ++k)
    {
      error = std::max(error, std::abs(seen[k] - expected[k]));
    }
    ++this->Rays;
    this->Worst = std::max(this->Worst, error);
    this->BeyondBound = std::max(this->BeyondBound, error - bound);
    this->Bound += bound;
    this->Error += error;
  }
};

inline std::ostream& operator<<(std::ostream& out, const ErrorTally& tally)
{
  return out << "worst " << tally.Worst << ", bound " << tally.Bound / tally.Error
             << " times the error, " << tally.Rays << " rays";
}

/// Premultiplied colour and opacity of a part of a ray, and the kernel's bound of their error.
template <typename Kernel>
Rgba pixelOf(
  Kernel& kernel, const typename Kernel::Ray& ray, const ScalarChord& chord, double& bound)
{
  const auto length = decltype(kernel.tableScale)(chord.Optical / (chord.End - chord.Begin));
  const auto march =
    kernel.castPlainRay(ray, length, decltype(length)(chord.Begin), decltype(length)(chord.End));
  const auto color = kernel.pixelOf(march.radiance, length);
  bound = double(kernel.errorBound(march.radiance));
  return { { double(color.x), double(color.y), double(color.z), double(color.w) } };
}
} // namespace tetmarch::testing

#endif
