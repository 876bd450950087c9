// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Means of colour and extinction along a cubic, and their bounds, against fine quadrature.
#include "Optics/BinAreas.h"
#include "Reference/MakeKernel.h"
#include "Reference/TrilinearKernel.h"

#include "LatticeGrids.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace
{
using namespace tetmarch;
using tetmarch::testing::uniform;

using Kernel = TrilinearKernel<double>;
using Function = std::function<OpticalSample(double)>; // r, g, b, extinction at 0..1

constexpr int Samples = 61;

IntegralTable tableOf(const Function& function)
{
  SampledFunctions functions;
  for (int i = 0; i < Samples; ++i)
  {
    functions.Samples.push_back(function(double(i) / (Samples - 1)));
  }
  functions.Before = functions.Samples.front();
  functions.After = functions.Samples.back();
  IntegralTable table = makeIntegralTable(functions);
  addExtinctionVariations(table);
  addSlopeVariations(table);
  return table;
}

OpticalSample straight(double f) { return { { 0.5, 0.5, 0.5, 0.1 + 0.8 * f } }; }
OpticalSample smooth(double f)
{
  return { { f, 0.5 + 0.5 * std::sin(6.0 * f), 1.0 - f, 0.5 + 0.4 * std::sin(9.0 * f) } };
}
OpticalSample kinked(double f)
{
  return { { f < 0.3 ? 0.2 : 0.9, f, 0.5,
    f > 0.4 && f < 0.6 ? 1.0 - 8.0 * std::abs(f - 0.5) : 0.2 } };
}

/// Of C tau and tau, between two places of the table along a cubic: midpoints.
std::array<double, 4> meanAlong(Kernel& kernel, double begin, double end, Kernel::vec2 bend)
{
  constexpr int Steps = 4000;
  std::array<double, 4> sum{};
  for (int i = 0; i < Steps; ++i)
  {
    const auto value = kernel.tableValue(kernel.bentScalar(begin, end, bend, (i + 0.5) / Steps));
    const std::array<double, 4> at{ { value.x * value.w, value.y * value.w, value.z * value.w,
      value.w } };
    for (int k = 0; k < 4; ++k)
    {
      sum[k] += at[k] / Steps;
    }
  }
  return sum;
}

/// Whether the scalar rises or falls all along, as it does in each part of a cell.
bool isMonotone(double rise, Kernel::vec2 bend)
{
  for (int i = 0; i <= 100; ++i)
  {
    const double x = i / 100.0;
    if ((rise - bend.x * (1 - 2 * x) - bend.y * (1 - 3 * x * x)) * rise < 0)
    {
      return false;
    }
  }
  return true;
}

struct Tally
{
  int Cases = 0;
  double BeyondBound = 0; // most
  double Straight = 0;    // the mean error of means along the straight line
  double Bent = 0;        // of those that take the bend into account
};

Tally tallyOf(const Function& function)
{
  const IntegralTable table = tableOf(function);
  auto kernel = makeKernel<Kernel, double>(table, { 0, 1, true }, {});
  std::mt19937 random(23);
  Tally tally;
  while (tally.Cases < 1000)
  {
    const double begin = -2 + (table.size() + 4) * uniform(random);
    const double end = begin + (random() % 2 ? 1 : -1) * 30 * uniform(random) * uniform(random);
    const double rise = end - begin;
    const Kernel::vec2 bend(rise * (2 * uniform(random) - 1), rise * (uniform(random) - 0.5));
    if (!isMonotone(rise, bend))
    {
      continue;
    }
    const auto p = kernel.tablePoint(begin);
    const auto q = kernel.tablePoint(end);
    const auto mean = kernel.meanBetween(p, q).mean;
    const auto found = kernel.bentMean(
      mean, kernel.weightedByExtinction(p.value), kernel.weightedByExtinction(q.value), bend, rise);
    const double perVariation = kernel.bentMeanError(bend, rise);
    const double ofExtinction = std::abs(q.slopeVariation.x - p.slopeVariation.x);
    const double ofEmission = std::abs(q.slopeVariation.y - p.slopeVariation.y);
    const std::array<double, 4> truth = meanAlong(kernel, begin, end, bend);
    const double found4[4] = { found.x, found.y, found.z, found.w };
    for (int k = 0; k < 4; ++k)
    {
      const double bound = perVariation * (k == 3 ? ofExtinction : ofEmission);
      tally.BeyondBound = std::max(tally.BeyondBound, std::abs(found4[k] - truth[k]) - bound);
    }
    tally.Straight += std::abs(mean.w - truth[3]);
    tally.Bent += std::abs(found.w - truth[3]);
    ++tally.Cases;
  }
  std::cout << "[ MEASURED ] error of the mean extinction: " << tally.Straight / tally.Cases
            << " along the straight line, " << tally.Bent / tally.Cases << " with the bend\n";
  return tally;
}

// Rounding of the table's integrals and of the quadrature.
constexpr double Rounding = 2e-6;

TEST(Bend, MeansOfStraightFunctionsAreExact)
{
  const Tally tally = tallyOf(straight);
  EXPECT_LE(tally.BeyondBound, Rounding);
  EXPECT_GT(tally.Straight, 20 * tally.Bent);
}

TEST(Bend, MeansOfOtherFunctionsKeepTheirBounds)
{
  const Tally ofSmooth = tallyOf(smooth);
  EXPECT_LE(ofSmooth.BeyondBound, Rounding);
  EXPECT_GT(ofSmooth.Straight, 3 * ofSmooth.Bent);
  EXPECT_LE(tallyOf(kinked).BeyondBound, Rounding);
}

TEST(Bend, SlopesVaryByTheirJumps)
{
  IntegralTable table;
  // Up by 1 an entry, down by 1 an entry, of one colour.
  for (const float extinction : { 0.0f, 0.0f, 1.0f, 2.0f, 1.0f, 0.0f, 0.0f })
  {
    table.Values.push_back({ { 0.5f, 0.5f, 0.5f, extinction } });
  }
  addSlopeVariations(table);
  const float expected[] = { 0, 1, 1, 3, 3, 4, 4 };
  for (std::size_t i = 0; i < table.SlopeVariations.size(); ++i)
  {
    EXPECT_EQ(table.SlopeVariations[i][0], expected[i]) << i;
    EXPECT_EQ(table.SlopeVariations[i][1], 0.5f * expected[i]) << i;
  }
}

} // namespace
