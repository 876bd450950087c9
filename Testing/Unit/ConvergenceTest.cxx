// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How fast each part of the error falls, one varied at a time, against its theoretical order (the
// method of Etiene, Kirby and Silva, "An introduction to verification of visualization techniques",
// 2013).
#include "Reference/FastPointKernel.h"
#include "Reference/PointKernel.h"

#include "UnitMeshes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

using Value = std::array<double, 4>;

Value smooth(double f)
{
  return { { 0.5 + 0.5 * std::sin(5.0 * f), 0.5 + 0.5 * std::cos(7.0 * f), 1.0 - f,
    0.4 + 0.3 * std::sin(9.0 * f) } };
}

// Colour jumps, extinction with it.
Value steps(double f)
{
  const double s = f > 0.62 ? 1.0 : (f > 0.31 ? 0.5 : 0.0);
  return { { s, 1.0 - s, 0.25 + 0.5 * s, 0.2 + 0.6 * s } };
}

// A ray on which the scalar runs from 0.05 to 0.95, in equal segments.
template <typename Kernel, typename Real>
std::array<double, 4> alongRay(
  const IntegralTable& table, int segments, double length, double tolerance)
{
  Kernel kernel = kernelOf<Kernel, Real>(TetMesh(), table);
  kernel.errorTolerance = Real(tolerance);
  kernel.mostTrials = 1 << 20;
  auto radiance = kernel.noRadiance();
  const auto scalar = [&](int i) { return Real(0.05 + 0.9 * i / segments); };
  typename Kernel::CellInterval cell{};
  for (int i = 0; i < segments && !kernel.isOpaque(radiance); ++i)
  {
    const typename Kernel::Segment segment{ { Real(i), scalar(i) },
      { Real(i + 1), scalar(i + 1) } };
    kernel.integrateSegment(segment, Real(length / segments), cell, radiance);
  }
  return { { double(radiance.color.x), double(radiance.color.y), double(radiance.color.z),
    1.0 - double(radiance.transmittance) } };
}

double distance(const std::array<double, 4>& a, const std::array<double, 4>& b)
{
  double most = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    most = std::max(most, std::abs(a[k] - b[k]));
  }
  return most;
}

constexpr double Never = 1e-30; // a transmittance at which no ray ends
constexpr double Length = 3.0;

// The mean order of the error when steps are halved, from the first error to the last.
double observedOrder(const std::vector<double>& errors)
{
  return std::log2(errors.front() / errors.back()) / double(errors.size() - 1);
}

// A segment that is not split: (h^2 / 12) times an integral of the change of colour, also across
// jumps.
TEST(Convergence, OfSegmentsTakenAsTheyAre)
{
  for (const auto& f : { smooth, steps })
  {
    const IntegralTable table = tableOf(f, 4096);
    const auto exact = alongRay<FastPointKernel<double>, double>(table, 1 << 18, Length, Never);
    std::vector<double> errors;
    for (int n = 32; n <= 1024; n *= 2)
    {
      errors.push_back(
        distance(alongRay<FastPointKernel<double>, double>(table, n, Length, Never), exact));
    }
    const double order = observedOrder(errors);
    std::cout << "[ MEASURED ] from " << errors.front() << " to " << errors.back() << ": order "
              << order << '\n';
    EXPECT_NEAR(order, 2.0, 0.3);
  }
}

// Split segments keep the tolerance however many cells there are: their error stays the same until
// cells are so small that nothing is split.
TEST(Convergence, OfSegmentsThatAreSplit)
{
  for (const auto& f : { smooth, steps })
  {
    const IntegralTable table = tableOf(f, 4096);
    const auto exact = alongRay<FastPointKernel<double>, double>(table, 1 << 18, Length, Never);
    for (const double tolerance : { 1.0 / 32.0, 1.0 / 255.0, 1.0 / 1024.0, 1e-4 })
    {
      for (int n = 1; n <= 1024; n *= 2)
      {
        const auto found = alongRay<PointKernel<double>, double>(table, n, Length, tolerance);
        EXPECT_LE(distance(found, exact), tolerance) << n << " segments";
      }
    }
  }
}

// The early end alone: off by its threshold at most, and by about as much.
TEST(Convergence, OfTheEarlyEnd)
{
  const IntegralTable table = tableOf(smooth, 4096);
  constexpr double thick = 60.0;
  constexpr int segments = 1 << 16;
  const auto exact = alongRay<FastPointKernel<double>, double>(table, segments, thick, Never);
  std::vector<double> errors;
  for (int i = 0; i < 6; ++i)
  {
    const double threshold = std::ldexp(1.0, -5 - i);
    errors.push_back(distance(
      alongRay<FastPointKernel<double>, double>(table, segments, thick, threshold), exact));
    EXPECT_LE(errors.back(), threshold);
  }
  EXPECT_NEAR(observedOrder(errors), 1.0, 0.3);
}

// The table alone: linear between entries.
TEST(Convergence, OfTheTable)
{
  constexpr int segments = 4096;
  const auto exact =
    alongRay<FastPointKernel<double>, double>(tableOf(smooth, 65536), segments, Length, Never);
  std::vector<double> errors;
  for (int n = 16; n <= 256; n *= 2)
  {
    // So many bins between the samples at 0 and 1.
    errors.push_back(distance(
      alongRay<FastPointKernel<double>, double>(tableOf(smooth, n + 5), segments, Length, Never),
      exact));
  }
  EXPECT_NEAR(observedOrder(errors), 2.0, 0.3);
}

// Float against double, apart from what the rules lose.
TEST(Convergence, FloatHasAFloor)
{
  const IntegralTable table = tableOf(smooth, 4096);
  for (int n = 1; n <= 1024; n *= 2)
  {
    const auto single = alongRay<FastPointKernel<float>, float>(table, n, Length, Never);
    const auto exact = alongRay<FastPointKernel<double>, double>(table, n, Length, Never);
    EXPECT_LE(distance(single, exact), 4e-6) << n << " segments";
  }
}
} // namespace
