// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far the colours that kernels see along rays are off, and whether their bounds hold
 */
#ifndef tetmarch_testing_RayTally_h
#define tetmarch_testing_RayTally_h

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace tetmarch::testing
{
using Rgba = std::array<double, 4>;

/// The error of float, tables and quadrature, which no bound includes.
constexpr double Rounding = 2e-5;

struct RayTally
{
  long Rays = 0;
  long Lost = 0; // or ended by the guard
  long Lookups = 0;
  double Worst = 0;       // error of a channel
  double BeyondBound = 0; // error less its bound
  double Bound = 0;       // sum
  double Error = 0;       // sum

  void add(const Rgba& seen, const Rgba& expected, double bound)
  {
    double error = 0;
    for (int k = 0; k < 4; ++k)
    {
      EXPECT_TRUE(std::isfinite(seen[k]));
      error = std::max(error, std::abs(seen[k] - expected[k]));
    }
    ++this->Rays;
    this->Worst = std::max(this->Worst, error);
    this->BeyondBound = std::max(this->BeyondBound, error - bound);
    this->Bound += bound;
    this->Error += error;
  }
};

inline void report(const char* what, const RayTally& tally)
{
  std::cout << "[ MEASURED ] " << what << ": worst " << tally.Worst << ", bound "
            << tally.Bound / tally.Error << " times the error, "
            << double(tally.Lookups) / double(tally.Rays) << " lookups a ray, " << tally.Rays
            << " rays\n";
}

template <typename Kernel>
using RealOf = decltype(Kernel::tableScale);

/// The march of a part of a ray: Begin and End are depths, perDepth() the thickness of a unit.
template <typename Kernel, typename Part>
typename Kernel::March marchOf(Kernel& kernel, const typename Kernel::Ray& ray, const Part& part)
{
  using Real = RealOf<Kernel>;
  return kernel.castPlainRay(ray, Real(part.perDepth()), Real(part.Begin), Real(part.End));
}

/// Premultiplied colour and opacity.
template <typename Kernel, typename Part>
Rgba pixelOf(Kernel& kernel, const typename Kernel::March& march, const Part& part)
{
  const auto color = kernel.pixelOf(march.radiance, RealOf<Kernel>(part.perDepth()));
  return { { double(color.x), double(color.y), double(color.z), double(color.w) } };
}

/// Adds rays of all kinds through the volume, against what expected(ray, part) says of them.
template <typename Volume, typename Kernel, typename Expected>
void tallyRays(
  RayTally& tally, const Volume& volume, Kernel kernel, int count, const Expected& expected)
{
  volume.forEachRay(kernel, count,
    [&](const typename Kernel::Ray& ray, const auto& part)
    {
      const auto march = marchOf(kernel, ray, part);
      tally.add(pixelOf(kernel, march, part), expected(ray, part),
        double(kernel.errorBound(march.radiance)));
      tally.Lost += march.lost + march.guarded;
      tally.Lookups += march.lookups;
    });
}

/// Against the truth of the volume.
template <typename Kernel, typename Volume>
void tallyTruth(RayTally& tally, const Volume& volume, int count)
{
  tallyRays(tally, volume, volume.template kernel<Kernel>(), count,
    [&volume](const auto& ray, const auto& part) { return volume.truth(ray, part); });
}
} // namespace tetmarch::testing

#endif
