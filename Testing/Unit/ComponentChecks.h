// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What is checked of rays through several components, in light and without
 */
#ifndef tetmarch_testing_ComponentChecks_h
#define tetmarch_testing_ComponentChecks_h

#include "ErrorTally.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <vector>

namespace tetmarch::testing
{
/// Of rays of all kinds, against what `expected` says of a ray and its part in the cube.
template <typename Kernel, typename Real, typename Expected>
ErrorTally tallyRays(const ComponentRays& rays, Kernel kernel, const Expected& expected)
{
  ErrorTally tally;
  rays.Rays.forEachRay<Kernel, Real>(
    kernel, rays.Fields[0],
    [&](const typename Kernel::Ray& ray, const ScalarChord& chord)
    {
      double bound = 0;
      const Rgba seen = pixelOf(kernel, ray, chord, bound);
      tally.add(seen, expected(ray, chord), bound);
    },
    400);
  return tally;
}

/// That each tolerance is kept in float, by a bound that holds, and that double is exact.
template <typename InFloat, typename InDouble>
void expectToleranceIsKept(
  ComponentRays& rays, const InFloat& tallyInFloat, const InDouble& tallyInDouble)
{
  for (const double tolerance : { 1.0 / 32.0, 1.0 / 255.0, 1.0 / 1024.0 })
  {
    AccuracyLevel level = levelOf(Accuracy::Default, tolerance);
    level.LeastTableEntries = 16384; // what is between entries is no part of the bound
    ASSERT_EQ(rays.use(level), "");
    const ErrorTally tally = tallyInFloat();
    std::cout << "[ MEASURED ] " << rays.Fields.size() << " components, tolerance 1/"
              << 1.0 / tolerance << ": " << tally << '\n';
    EXPECT_GT(tally.Rays, 150);
    EXPECT_LE(tally.Worst, tolerance);
    EXPECT_LE(tally.BeyondBound, Rounding);
  }
  ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
  const ErrorTally exact = tallyInDouble();
  std::cout << "[ MEASURED ] in double: " << exact << '\n';
  EXPECT_LE(exact.Worst, 1e-5);
}

/// That a ray through one of two cells alone has the colour of that cell. inLight says what light
/// makes of the premultiplied colour on a ray; rays of less opacity are left out.
template <typename Kernel, typename InLight>
void expectColorsOfCells(
  const ComponentRays& rays, Kernel kernel, double leastOpacity, const InLight& inLight)
{
  RandomRays random(3);
  int checked = 0;
  for (int i = 0; i < 200; ++i)
  {
    const auto ray = random.next<Kernel, double>(kernel, rays.Rays.Mesh);
    // A unit of depth is three scalar opacity unit distances.
    const auto march = kernel.castPlainRay(ray, 3.0, -3.0, 3.0);
    const auto color = kernel.pixelOf(march.radiance, 3.0);
    const auto isOfCell = [&](int cell)
    {
      std::vector<double> tuple(rays.Fields.size());
      rays.Data->GetCellData()->GetScalars()->GetTuple(cell, tuple.data());
      const Rgba medium = mediumAt(rays.Property, tuple); // C tau, tau
      const double scale = color.w / medium[3];
      const Rgba expected =
        inLight(ray, Rgba{ { medium[0] * scale, medium[1] * scale, medium[2] * scale, color.w } });
      return std::abs(color.x - expected[0]) < 1e-4 && std::abs(color.y - expected[1]) < 1e-4 &&
             std::abs(color.z - expected[2]) < 1e-4;
    };
    if (march.cells == 1 && color.w > leastOpacity)
    {
      EXPECT_TRUE(isOfCell(0) || isOfCell(1));
      ++checked;
    }
  }
  EXPECT_GT(checked, 20);
}
} // namespace tetmarch::testing

#endif
