// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Means over intervals of the table against integration bin by bin.
#include "Reference/PointKernel.h"
#include "Reference/PortablePointKernel.h"

#include "UnitMeshes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

using Value = std::array<double, 4>;

// Step, spike of one bin, ramps, zeros.
Value spiky(double f)
{
  const double tau =
    f > 0.2 && f < 0.2015 ? 1.0 : (f < 0.5 ? 0.1 * f : (f < 0.6 ? 0.0 : 0.9 - 0.5 * f));
  return { { f < 0.3 ? 0.2 : 0.9, 0.5 + 0.5 * std::sin(40.0 * f), 1.0 - f, tau } };
}

Value smooth(double f)
{
  return { { f, 0.5 + 0.5 * std::sin(6.0 * f), (1.0 - f) * (1.0 - f), 0.2 + 0.5 * f * f } };
}

// The table as IntegralTable.h defines it: linear between entries, constant beyond them.
Value valueAt(const IntegralTable& table, double x)
{
  const int bin = std::min(std::max(static_cast<int>(std::floor(x)), 0), table.size() - 2);
  const double share = std::min(std::max(x - bin, 0.0), 1.0);
  Value value;
  for (int k = 0; k < 4; ++k)
  {
    value[k] =
      double(table.Values[bin][k]) * (1.0 - share) + double(table.Values[bin + 1][k]) * share;
  }
  return value;
}

// Means of C tau and tau: Simpson's rule, exact for the parabolas between entries.
Value meansBetween(const IntegralTable& table, double x0, double x1)
{
  const double low = std::min(x0, x1);
  const double high = std::max(x0, x1);
  const auto integrand = [&](double x)
  {
    const Value v = valueAt(table, x);
    return Value{ { v[0] * v[3], v[1] * v[3], v[2] * v[3], v[3] } };
  };
  Value sum{};
  for (double a = low; a < high;)
  {
    // Beyond the table one interval will do.
    const double next = a < 0.0 ? 0.0 : (a >= table.size() - 1 ? high : std::floor(a) + 1.0);
    const double b = std::min(next, high);
    const auto p = integrand(a), m = integrand(0.5 * (a + b)), q = integrand(b);
    for (int k = 0; k < 4; ++k)
    {
      sum[k] += (b - a) / (high - low) * (p[k] + 4.0 * m[k] + q[k]) / 6.0;
    }
    a = b;
  }
  return low < high ? sum : integrand(low);
}

// Means against the reference, relative to the largest value that the table holds; by a kernel that
// reads both ends of an interval, or by one that keeps an end.
template <typename Kernel, typename Real>
double worstError(const IntegralTable& table, double widest)
{
  const TetMesh none;
  auto kernel = kernelOf<Kernel, Real>(none, table);
  std::mt19937 random(41);
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i)
  {
    const Real x0 = Real(-20.0 + (table.size() + 40) * uniform(random));
    const double width = widest * std::pow(10.0, -10.0 * uniform(random));
    const Real x1 = Real(double(x0) + (i % 2 ? width : -width));
    const auto mean = kernel.meanOver(x0, x1).mean;
    const auto expected = meansBetween(table, double(x0), double(x1));
    const double found[4] = { double(mean.x), double(mean.y), double(mean.z), double(mean.w) };
    for (int k = 0; k < 4; ++k)
    {
      worst = std::max(worst, std::abs(found[k] - expected[k]));
    }
  }
  return worst;
}

TEST(IntegralTable, MeansOfIntervalsOfEveryWidth)
{
  for (const int entries : { 16, 1024, 4096 })
  {
    for (const auto& f : { spiky, smooth })
    {
      const IntegralTable table = tableOf(f, entries);
      EXPECT_EQ(table.size(), entries);
      // Both ends of a difference are rounded to half a unit. The interval between two bins is at
      // least one bin wide, or the difference is of one entry: 0.
      double unit = 0.0;
      for (const double u : table.IntegralUnit)
      {
        unit = std::max(unit, u);
      }
      // The table's values are floats, its integrals come from the samples: 2^-25 of each factor.
      // Float: a dozen operations on numbers up to 1, 2^-24 each.
      const double exact = unit + 4 * std::ldexp(1.0, -25);
      const double rounded = unit + 12 * std::ldexp(1.0, -24);
      EXPECT_LT((worstError<PointKernel<double>, double>(table, entries)), exact);
      EXPECT_LT((worstError<PortablePointKernel<double>, double>(table, entries)), exact);
      for (const double widest : { double(entries), 1.0 })
      {
        EXPECT_LT((worstError<PointKernel<float>, float>(table, widest)), rounded);
        EXPECT_LT((worstError<PortablePointKernel<float>, float>(table, widest)), rounded);
      }
    }
  }
}

TEST(IntegralTable, SpikesBetweenTheEndsAreNeverMissed)
{
  const IntegralTable table = tableOf(
    [](double f) {
      return Value{ { 1.0, 0.5, 0.25, std::abs(f - 0.5) < 1e-3 ? 1.0 : 0.0 } };
    });
  const TetMesh none;
  auto kernel = kernelOf<PointKernel<float>, float>(none, table);
  const auto mean = kernel.meanOver(100.0f, 900.0f).mean;
  const auto expected = meansBetween(table, 100.0, 900.0);
  EXPECT_GT(expected[3], 1e-3);
  EXPECT_NEAR(double(mean.w), expected[3], 1e-6 * expected[3] + table.IntegralUnit[3] / 800);
  EXPECT_NEAR(double(mean.y), expected[1], 1e-6 * expected[1] + table.IntegralUnit[1] / 800);
}

// The variation between two positions is at least that of any channel, and at most that of all.
TEST(IntegralTable, VariationBoundsEveryChannel)
{
  const IntegralTable table = tableOf(smooth);
  auto kernel = kernelOf<PointKernel<double>, double>(TetMesh(), table);
  std::mt19937 random(43);
  for (int i = 0; i < 200; ++i)
  {
    const double x0 = -20.0 + (table.size() + 40) * uniform(random);
    const double x1 = x0 + 100.0 * (uniform(random) - 0.5);
    Value change{};
    constexpr int Steps = 4000;
    for (int k = 0; k < 3; ++k)
    {
      double before = valueAt(table, x0)[k];
      for (int j = 1; j <= Steps; ++j)
      {
        const double value = valueAt(table, x0 + (x1 - x0) * j / Steps)[k];
        change[k] += std::abs(value - before);
        before = value;
      }
    }
    const double found = kernel.meanOver(x0, x1).variation;
    const double slack = 1e-5; // of the variations, which are floats
    EXPECT_GE(found, std::max({ change[0], change[1], change[2] }) - slack);
    EXPECT_LE(found, change[0] + change[1] + change[2] + slack);
  }
}

// Two spikes of different colours with nothing between them: neither gets the other's colour.
TEST(IntegralTable, ColoursWithoutExtinctionDontVary)
{
  const IntegralTable table = tableOf(
    [](double f)
    {
      const double tau = std::abs(f - 0.25) < 0.01 || std::abs(f - 0.75) < 0.01 ? 1.0 : 0.0;
      const double red = f < 0.5 ? 0.1 : 0.9;
      // Half of the bin beside a spike is seen.
      const bool near = std::abs(f - 0.25) < 0.02 || std::abs(f - 0.75) < 0.02;
      return Value{ { near ? red : f, 0.5, near ? 1.0 - red : 0.5, tau } };
    });
  auto kernel = kernelOf<PointKernel<float>, float>(TetMesh(), table);
  const auto variation = [&](double f0, double f1)
  {
    const auto n = static_cast<double>(table.size());
    return kernel.meanOver(static_cast<float>(f0 * n), static_cast<float>(f1 * n)).variation;
  };
  EXPECT_EQ(variation(0.0, 0.4), 0.0f);
  EXPECT_EQ(variation(0.6, 1.0), 0.0f);
  EXPECT_NEAR(double(variation(0.0, 1.0)), 0.8, 1e-6);
}

TEST(IntegralTable, OfNothing)
{
  const IntegralTable table = tableOf([](double) { return Value{}; });
  EXPECT_EQ(table.IntegralUnit[3], 0.0);
  EXPECT_EQ((worstError<PointKernel<float>, float>(table, 100.0)), 0.0);
}

TEST(IntegralTable, PositionsOfScalars)
{
  SampledFunctions functions;
  functions.Begin = -3.0;
  functions.End = 7.0;
  functions.Samples.assign(samplesOfTable(64), { { 1.0, 1.0, 1.0, 1.0 } });
  const IntegralTable table = makeIntegralTable(functions);
  // First sample: entry 2; last one: entry n - 3.
  EXPECT_DOUBLE_EQ(table.offset(-3.0), 2.0);
  EXPECT_DOUBLE_EQ(table.offset(-3.0) + table.scale(10.0), 61.0);
  EXPECT_DOUBLE_EQ(table.offset(2.0), 31.5);
}
} // namespace
