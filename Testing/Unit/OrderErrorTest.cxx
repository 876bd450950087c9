// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The bound of what a segment loses by integrating its colours without their order.
#include "Reference/PointKernel.h"

#include "LatticeGrids.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// 1 - phi + phi ln(phi), phi = (1 - exp(-D)) / D.
double greatestLoss(double depth)
{
  const double phi = -std::expm1(-depth) / depth;
  return 1.0 - phi + phi * std::log(phi);
}

template <typename Real>
void expectFactor(double slack)
{
  PointKernel<Real> kernel;
  for (double depth = 0.03; depth < 1e4; depth *= 1.01)
  {
    const double found = double(kernel.orderErrorFactor(Real(depth)));
    EXPECT_GE(found, greatestLoss(depth) * (1.0 - slack)) << depth;
    EXPECT_LE(found, greatestLoss(depth) * 1.04) << depth;
  }
  // The closed form cancels in thinner ones.
  for (double depth = 1e-12; depth < 0.03; depth *= 1.3)
  {
    const double found = double(kernel.orderErrorFactor(Real(depth)));
    EXPECT_GE(found, depth * depth * (0.125 - 0.0625 * depth) * (1.0 - slack)) << depth;
    EXPECT_LE(found, depth * depth * 0.125 * (1.0 + slack)) << depth;
  }
  EXPECT_EQ(kernel.orderErrorFactor(std::numeric_limits<Real>::infinity()), Real(1));
  EXPECT_LT(kernel.orderErrorFactor(Real(0)), Real(1e-29));
}

TEST(OrderError, FactorIsAboveTheLossAndNear)
{
  expectFactor<double>(1e-9);
  expectFactor<float>(1e-6);
}

// Colours as steps along the optical depth: exact sums, with the steps where they cost most among
// them.
TEST(OrderError, BoundsWhatAnyColoursLose)
{
  std::mt19937 random(61);
  PointKernel<double> kernel;
  double nearest = 0.0;
  for (int i = 0; i < 20000; ++i)
  {
    const double depth = std::pow(10.0, -2.0 + 4.0 * uniform(random));
    const double phi = -std::expm1(-depth) / depth;
    std::vector<double> ends{ 0.0, depth };
    const int steps = 1 + i % 6;
    for (int j = 0; j < steps; ++j)
    {
      ends.push_back(steps == 1 ? -std::log(phi) : depth * uniform(random));
    }
    std::sort(ends.begin(), ends.end());
    double exact = 0.0, even = 0.0, variation = 0.0, before = 0.0;
    for (std::size_t j = 0; j + 1 < ends.size(); ++j)
    {
      const double colour = steps == 1 ? double(j) : uniform(random);
      exact += colour * (std::exp(-ends[j]) - std::exp(-ends[j + 1]));
      even += colour * (ends[j + 1] - ends[j]) * phi;
      variation += j > 0 ? std::abs(colour - before) : 0.0;
      before = colour;
    }
    const double bound = variation * kernel.orderErrorFactor(depth);
    EXPECT_LE(std::abs(exact - even), bound + 1e-14);
    nearest = std::max(nearest, std::abs(exact - even) / bound);
  }
  EXPECT_GT(nearest, 0.99);
}
} // namespace
