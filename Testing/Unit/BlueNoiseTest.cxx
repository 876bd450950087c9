// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tile of blue noise: each rank once, little power in low frequencies, no seam.
#include "View/BlueNoise.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <random>

namespace
{
using namespace tetmarch;

constexpr int Side = BlueNoiseSide;
constexpr int Count = Side * Side;

// The same numbers in no order: white noise.
std::vector<float> shuffled(std::vector<float> tile)
{
  std::mt19937 random(7);
  for (std::size_t i = tile.size(); i > 1; --i)
  {
    std::swap(tile[i - 1], tile[random() % i]);
  }
  return tile;
}

// Mean power of the wave numbers up to `most`, but for the mean.
double lowPower(const std::vector<float>& tile, int most)
{
  double sum = 0;
  int waves = 0;
  for (int ky = -most; ky <= most; ++ky)
  {
    for (int kx = 0; kx <= most; ++kx)
    {
      if ((kx == 0 && ky <= 0) || kx * kx + ky * ky > most * most)
      {
        continue;
      }
      std::complex<double> amplitude = 0;
      for (int i = 0; i < Count; ++i)
      {
        const int turn = (kx * (i % Side) + ky * (i / Side)) % Side;
        amplitude += static_cast<double>(tile[i]) *
                     std::polar(1.0, 2.0 * vtkMath::Pi() * turn / static_cast<double>(Side));
      }
      sum += std::norm(amplitude) / Count;
      ++waves;
    }
  }
  return sum / waves;
}

TEST(BlueNoise, HasEachRankOnce)
{
  std::vector<float> sorted = blueNoiseTile();
  ASSERT_EQ(sorted.size(), static_cast<std::size_t>(Count));
  std::sort(sorted.begin(), sorted.end());
  for (int rank = 0; rank < Count; ++rank)
  {
    ASSERT_EQ(sorted[rank], (static_cast<float>(rank) + 0.5f) / Count);
  }
}

TEST(BlueNoise, IsKept) { EXPECT_EQ(&blueNoiseTile(), &blueNoiseTile()); }

TEST(BlueNoise, HasLittlePowerInLowFrequencies)
{
  const std::vector<float>& tile = blueNoiseTile();
  const std::vector<float> white = shuffled(tile);
  for (const int most : { 4, 8, 12 })
  {
    EXPECT_LT(10.0 * lowPower(tile, most), lowPower(white, most)) << most;
  }
}

// Dithering takes the places below a threshold: none of these clump, at any threshold.
TEST(BlueNoise, EveryThresholdIsEven)
{
  const std::vector<float>& tile = blueNoiseTile();
  const std::vector<float> white = shuffled(tile);
  for (const float threshold : { 0.05f, 0.1f, 0.25f, 0.5f, 0.75f, 0.9f })
  {
    const auto powerBelow = [&](std::vector<float> values)
    {
      for (float& value : values)
      {
        value = value < threshold ? 1.0f : 0.0f;
      }
      return lowPower(values, 6);
    };
    EXPECT_LT(5.0 * powerBelow(tile), powerBelow(white)) << threshold;
  }
}

// Differences of neighbours, those at corners too.
std::vector<double> differences(const std::vector<float>& tile, bool acrossBorder)
{
  const int ways[][2] = { { 1, 0 }, { -1, 1 }, { 0, 1 }, { 1, 1 } };
  std::vector<double> found;
  for (int i = 0; i < Count; ++i)
  {
    for (const auto& way : ways)
    {
      const int x = i % Side + way[0];
      const int y = i / Side + way[1];
      const int j = y % Side * Side + (x + Side) % Side;
      if ((x < 0 || x == Side || y == Side) == acrossBorder)
      {
        found.push_back(std::abs(static_cast<double>(tile[i]) - static_cast<double>(tile[j])));
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Greatest difference of the shares below any value (Kolmogorov and Smirnov).
double distance(const std::vector<double>& a, const std::vector<double>& b)
{
  const auto shareBelow = [](const std::vector<double>& values, double most)
  {
    const auto end = std::upper_bound(values.begin(), values.end(), most);
    return static_cast<double>(end - values.begin()) / static_cast<double>(values.size());
  };
  double greatest = 0;
  for (const double value : a)
  {
    greatest = std::max(greatest, std::abs(shareBelow(a, value) - shareBelow(b, value)));
  }
  return greatest;
}

TEST(BlueNoise, HasNoSeam)
{
  const std::vector<float>& tile = blueNoiseTile();
  const auto inside = differences(tile, false);
  const auto across = differences(tile, true);
  const auto white = differences(shuffled(tile), true);
  ASSERT_EQ(across.size(), static_cast<std::size_t>(6 * Side - 2));
  // So many of the same distribution differ by more than this in one case of a hundred.
  const double most = 1.63 / std::sqrt(static_cast<double>(across.size()));
  EXPECT_LT(distance(across, inside), most);
  EXPECT_GT(distance(white, inside), most);
}
} // namespace
