// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Samples of a table keep the area of what lies between them.
#include "Optics/BinAreas.h"

#include "LatticeGrids.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

using Function = std::function<OpticalSample(double)>;

std::vector<OpticalSample> sampled(const Function& f, int bins, int perBin)
{
  std::vector<OpticalSample> samples;
  for (int i = 0; i <= bins * perBin; ++i)
  {
    samples.push_back(f(static_cast<double>(i) / perBin));
  }
  return samples;
}

// The integrals of C tau and tau between the samples.
std::array<double, 4> areasOf(const std::vector<OpticalSample>& samples, int perBin)
{
  std::array<double, 4> sum{};
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
  {
    const auto part = linearIntegrals(samples[i], samples[i + 1]);
    for (int k = 0; k < 4; ++k)
    {
      sum[k] += part[k] / perBin;
    }
  }
  return sum;
}

TEST(BinAreas, LinearBinsStayAsTheyAre)
{
  std::mt19937 random(61);
  std::vector<OpticalSample> nodes(21);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    for (double& x : nodes[i])
    {
      x = i % 5 == 0 ? 0.0 : uniform(random);
    }
  }
  const auto f = [&](double x)
  {
    const auto i = std::min(static_cast<std::size_t>(x), nodes.size() - 2);
    OpticalSample s;
    for (int k = 0; k < 4; ++k)
    {
      s[k] = nodes[i][k] + (x - static_cast<double>(i)) * (nodes[i + 1][k] - nodes[i][k]);
    }
    return s;
  };
  const auto kept = keepBinAreas(sampled(f, 20, 16), 16);
  ASSERT_EQ(kept.size(), nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    // Where nothing is absorbed there is no colour to keep.
    EXPECT_NEAR(kept[i][3], nodes[i][3], 1e-12);
    for (int k = 0; k < 3 && nodes[i][3] > 0.0; ++k)
    {
      EXPECT_NEAR(kept[i][k], nodes[i][k], 1e-12) << i;
    }
  }
}

// A spike, wherever it is in the bin; point samples miss it, or take it for much wider.
TEST(BinAreas, SpikesAndStepsKeepTheirAreas)
{
  double errorKept = 0.0, errorOfPoints = 0.0;
  for (int i = 0; i < 32; ++i)
  {
    const double x0 = 7.0 + i / 16.0;
    const auto spike = [x0](double x) {
      return OpticalSample{ { 0.9, 0.2, 0.4, std::max(0.0, 1.0 - 4.0 * std::abs(x - x0)) } };
    };
    const auto step = [x0](double x)
    {
      return x < x0 ? OpticalSample{ { 0.1, 0.2, 1.0, 0.0 } }
                    : OpticalSample{ { 0.8, 0.5, 0.0, 1.0 } };
    };
    for (const Function& f : { Function(spike), Function(step) })
    {
      const auto fine = sampled(f, 20, 16);
      const auto kept = keepBinAreas(fine, 16);
      const auto expected = areasOf(fine, 16);
      const auto found = areasOf(kept, 1);
      const auto points = areasOf(sampled(f, 20, 1), 1);
      EXPECT_NEAR(found[3], expected[3], 1e-12) << i;
      for (int k = 0; k < 3; ++k)
      {
        errorKept += std::abs(found[k] - expected[k]);
        errorOfPoints += std::abs(points[k] - expected[k]);
      }
      for (std::size_t bin = 0; bin < kept.size(); ++bin)
      {
        EXPECT_GE(kept[bin][3], 0.0);
        if (std::abs(static_cast<double>(bin) - x0) > 2.5)
        {
          EXPECT_EQ(kept[bin][3], fine[16 * bin][3]); // far from it nothing changes
        }
      }
    }
  }
  // Products of linear colours and extinctions aren't linear, so of C tau something is left over.
  EXPECT_LT(errorKept, 0.4 * errorOfPoints);
  RecordProperty("share", std::to_string(errorKept / errorOfPoints));
}

// Also where extinction begins within a bin, so that little of the colour is seen.
TEST(BinAreas, ColoursAreOfThoseSeenThere)
{
  for (int i = 0; i < 64; ++i)
  {
    const double x0 = 7.0 + i / 32.0;
    const auto gap = [x0](double x)
    {
      const double inGap = std::min(x - x0 + 0.5, x0 + 0.5 - x);
      return OpticalSample{ { 0.03 * x, 1.0 - 0.04 * x, 0.5, std::max(0.0, -0.1 * inGap) } };
    };
    const auto fine = sampled(gap, 20, 16);
    const auto kept = keepBinAreas(fine, 16);
    for (std::size_t bin = 0; bin < kept.size(); ++bin)
    {
      const double x = static_cast<double>(bin);
      EXPECT_NEAR(kept[bin][0], 0.03 * x, 0.031) << i;
      EXPECT_NEAR(kept[bin][1], 1.0 - 0.04 * x, 0.041) << i;
      EXPECT_NEAR(kept[bin][2], 0.5, 1e-12) << i;
    }
  }
}

// A dip to 0 between two samples, as narrow as a fine one: nothing gets below 0.
TEST(BinAreas, DipsStayAboveZero)
{
  const auto comb = [](double x)
  {
    const double share = x - std::floor(x);
    return OpticalSample{ { 1.0, 0.5, 0.0, share == 0.0 ? 1.0 : 0.0 } };
  };
  const auto fine = sampled(comb, 10, 16);
  const auto kept = keepBinAreas(fine, 16);
  for (const OpticalSample& s : kept)
  {
    EXPECT_GE(s[3], 0.0);
    EXPECT_LE(s[3], 1.0);
    EXPECT_GE(s[1], 0.0);
    EXPECT_LE(s[0], 1.0);
  }
}
} // namespace
