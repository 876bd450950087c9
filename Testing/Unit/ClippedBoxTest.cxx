// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What clipping and cropping leave of a box, beside the points of a lattice that they leave.
#include "View/ClippedBox.h"

#include "Scalars/HiddenBits.h"
#include "View/Clipping.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace
{
using namespace tetmarch;

constexpr std::array<double, 3> Half{ { 0.6, 0.5, 0.4 } };
constexpr int Steps = 24;

class Random
{
public:
  double between(double low, double high)
  {
    return low + (high - low) * this->Engine() / 4294967296.0;
  }
  int below(int count) { return static_cast<int>(this->Engine() % static_cast<unsigned>(count)); }

private:
  std::mt19937 Engine{ 7 };
};

std::array<double, 4> planeAcross(Random& random, double farthest)
{
  std::array<double, 4> plane{};
  double length = 0;
  while (length < 0.1)
  {
    for (int k = 0; k < 3; ++k)
    {
      plane[k] = random.between(-1, 1);
    }
    length = std::hypot(plane[0], plane[1], plane[2]);
  }
  for (int k = 0; k < 3; ++k)
  {
    plane[k] /= length;
  }
  plane[3] = random.between(-farthest, farthest);
  return plane;
}

// By how much planes and regions have the point inside; below 0: outside.
double depthIn(const Clipping& clipping, const std::array<double, 3>& point)
{
  double depth = 1;
  int region = 0;
  for (int k = 2; k >= 0; --k)
  {
    const int part = point[k] < clipping.CroppingLow[k]    ? 0
                     : point[k] < clipping.CroppingHigh[k] ? 1
                                                           : 2;
    region = 3 * region + part;
  }
  for (const auto& plane : clipping.Planes)
  {
    depth =
      std::min(depth, plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] + plane[3]);
  }
  return clipping.CroppingFlags >> region & 1 ? depth : -1;
}

// Whether some point of a lattice over the box is inside by `depth`, or less outside than by
// -depth.
bool hasPoint(const Clipping& clipping, double depth)
{
  for (int i = 0; i <= Steps; ++i)
  {
    for (int j = 0; j <= Steps; ++j)
    {
      for (int k = 0; k <= Steps; ++k)
      {
        const std::array<double, 3> point{ { Half[0] * (2.0 * i / Steps - 1),
          Half[1] * (2.0 * j / Steps - 1), Half[2] * (2.0 * k / Steps - 1) } };
        if (depthIn(clipping, point) >= depth)
        {
          return true;
        }
      }
    }
  }
  return false;
}

// No point of the box is farther from the lattice than 0.037: what is left has a point there, or
// nearly.
TEST(ClippedBox, AsPointsOfALattice)
{
  Random random;
  int empty = 0;
  int some = 0;
  for (int round = 0; round < 2000; ++round)
  {
    Clipping clipping;
    const int planes = random.below(5);
    for (int p = 0; p < planes; ++p)
    {
      clipping.Planes.push_back(planeAcross(random, 0.5));
    }
    const bool nothing = leavesNothing(clipping, Half);
    (nothing ? empty : some) += 1;
    EXPECT_FALSE(nothing && hasPoint(clipping, 0)) << round;
    EXPECT_TRUE(nothing || hasPoint(clipping, -0.037)) << round;
  }
  EXPECT_GT(empty, 100);
  EXPECT_GT(some, 100);
}

TEST(ClippedBox, RegionsThatAreNoBox)
{
  Random random;
  int empty = 0;
  int some = 0;
  for (int round = 0; round < 1000; ++round)
  {
    Clipping clipping;
    clipping.Cropped = true;
    clipping.CroppingFlags = 1 << random.below(27) | 1 << random.below(27);
    for (int k = 0; k < 3; ++k)
    {
      clipping.CroppingLow[k] = random.between(-0.8, 0.3);
      clipping.CroppingHigh[k] = random.between(clipping.CroppingLow[k], 0.8);
    }
    if (round % 2)
    {
      clipping.Planes.push_back(planeAcross(random, 0.5));
    }
    const bool nothing = leavesNothing(clipping, Half);
    (nothing ? empty : some) += 1;
    EXPECT_FALSE(nothing && hasPoint(clipping, 1e-6)) << round;
  }
  EXPECT_GT(empty, 100);
  EXPECT_GT(some, 100);
}

TEST(ClippedBox, ThatIsOnlyTouchedIsLeft)
{
  for (const double beyond : { -1e-12, 0.0, 1e-12 })
  {
    Clipping clipping;
    clipping.Planes.push_back({ { 1, 0, 0, -Half[0] - beyond } });
    EXPECT_FALSE(leavesNothing(clipping, Half));
    clipping.Planes.back()[3] -= 1e-6;
    EXPECT_TRUE(leavesNothing(clipping, Half));
  }
  EXPECT_FALSE(leavesNothing(Clipping(), Half));
}

TEST(HiddenBits, OfAllCells)
{
  EXPECT_FALSE(areAllHidden({}, 5)) << "none is";
  for (const std::uint64_t cells : { 1, 31, 32, 33, 64, 100 })
  {
    std::vector<std::uint32_t> words((cells + 31) / 32);
    for (std::uint64_t c = 0; c < cells; ++c)
    {
      EXPECT_FALSE(areAllHidden(words, cells)) << c << " of " << cells;
      words[c / 32] |= std::uint32_t(1) << c % 32;
    }
    EXPECT_TRUE(areAllHidden(words, cells)) << cells;
    words[0] &= ~1u;
    EXPECT_FALSE(areAllHidden(words, cells)) << cells;
  }
}
} // namespace
