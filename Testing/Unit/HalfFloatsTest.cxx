// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Halves against a decoder of their own, and what packing does to gradients.
#include "Mesh/HalfFloats.h"

#include "LatticeGrids.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

double decoded(std::uint16_t half)
{
  const int exponent = half >> 10 & 31;
  const int mantissa = half & 1023;
  const double size =
    exponent == 31
      ? (mantissa ? std::nan("") : std::numeric_limits<double>::infinity())
      : (exponent ? std::ldexp(1024 + mantissa, exponent - 25) : std::ldexp(mantissa, -24));
  return half & 0x8000 ? -size : size;
}

TEST(HalfFloats, AllComeBack)
{
  for (int i = 0; i < 0x10000; ++i)
  {
    const auto half = static_cast<std::uint16_t>(i);
    const double value = decoded(half);
    const std::uint16_t again = toHalf(static_cast<float>(value));
    if (std::isnan(value))
    {
      EXPECT_TRUE(std::isnan(decoded(again))) << i;
    }
    else if (std::isinf(value))
    {
      EXPECT_EQ(decoded(again), std::copysign(65504.0, value));
    }
    else
    {
      EXPECT_EQ(again, half);
    }
  }
}

// What lies halfway goes to the even one, and its neighbours among floats to the nearest.
TEST(HalfFloats, AreTheNearest)
{
  for (int i = 0; i < 0x7bff; ++i)
  {
    const auto below = static_cast<std::uint16_t>(i);
    const auto above = static_cast<std::uint16_t>(i + 1);
    const auto middle = static_cast<float>(0.5 * (decoded(below) + decoded(above)));
    ASSERT_EQ(toHalf(middle), i % 2 == 0 ? below : above) << i;
    ASSERT_EQ(toHalf(std::nextafter(middle, 0.0f)), below) << i;
    ASSERT_EQ(toHalf(std::nextafter(middle, 1e9f)), above) << i;
    ASSERT_EQ(toHalf(-middle), toHalf(middle) | 0x8000) << i;
  }
}

TEST(HalfFloats, HugeAndTinyOnes)
{
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float huge : { 65504.0f, 65519.0f, 65520.0f, 1e10f, infinity })
  {
    EXPECT_EQ(toHalf(huge), 0x7bff) << huge;
    EXPECT_EQ(toHalf(-huge), 0xfbff) << huge;
  }
  for (const float tiny : { 0.0f, 1e-45f, 1e-30f, 2.9e-8f })
  {
    EXPECT_EQ(toHalf(tiny), 0) << tiny;
    EXPECT_EQ(toHalf(-tiny), 0x8000) << tiny;
  }
}

TEST(PackedGradients, KeepDirectionsAndLengths)
{
  std::mt19937 random(7);
  std::vector<Gradient> gradients;
  for (int i = 0; i < 200000; ++i)
  {
    Gradient g;
    const double size = std::pow(10.0, 3.0 - 6.0 * uniform(random));
    for (float& component : g)
    {
      component = static_cast<float>(size * (2.0 * uniform(random) - 1.0));
    }
    gradients.push_back(g);
  }
  const PackedGradients packed = packGradients(gradients);
  ASSERT_EQ(packed.Texels.size(), gradients.size());
  double largest = 0, angle = 0, stretch = 0;
  for (std::size_t i = 0; i < gradients.size(); ++i)
  {
    double dot = 0, before = 0, after = 0, cross = 0;
    double p[3], q[3];
    for (int k = 0; k < 3; ++k)
    {
      p[k] = double(gradients[i][k]);
      q[k] = packed.Unit * decoded(packed.Texels[i][k]);
      dot += p[k] * q[k];
      before += p[k] * p[k];
      after += q[k] * q[k];
      largest = std::max(largest, std::abs(decoded(packed.Texels[i][k])));
    }
    for (int k = 0; k < 3; ++k)
    {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      cross += (p[l] * q[m] - p[m] * q[l]) * (p[l] * q[m] - p[m] * q[l]);
    }
    angle = std::max(angle, std::atan2(std::sqrt(cross), dot));
    stretch = std::max(stretch, std::abs(std::sqrt(after / before) - 1.0));
    EXPECT_EQ(packed.Texels[i][3], 0);
  }
  angle *= 180.0 / std::acos(-1.0);
  std::cout << "[ MEASURED ] directions are off by " << angle << " degrees at most, lengths by "
            << 100.0 * stretch << " %, the largest component is " << largest << '\n';
  EXPECT_LT(angle, 0.06);
  EXPECT_LT(stretch, 6e-4);
  EXPECT_NEAR(largest, 60000.0, 32.0);
}

TEST(PackedGradients, OfNothing)
{
  EXPECT_EQ(packGradients({}).Unit, 1.0);
  const PackedGradients zeros = packGradients({ {}, {} });
  EXPECT_EQ(zeros.Unit, 1.0);
  EXPECT_EQ(zeros.Texels, (std::vector<std::array<std::uint16_t, 4>>(2)));
  for (const float size : { 1e-45f, 1e-30f, 3e38f })
  {
    const PackedGradients one = packGradients({ { { 0.0f, -size, 0.0f } } });
    EXPECT_NEAR(decoded(one.Texels[0][1]), -60000.0, 32.0) << size;
  }
}
} // namespace
