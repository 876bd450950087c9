// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Budget/SampleDistance.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using tetmarch::SampleDistance;

// A machine on which a frame with a ray for each pixel takes so long.
double settled(SampleDistance& distance, double fullSeconds, double seconds)
{
  double d = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    d = distance.choose(seconds, 1.0, 100.0);
    distance.drawn(d, fullSeconds / (d * d));
  }
  return d;
}

TEST(SampleDistance, AllRaysIfNothingIsKnown)
{
  SampleDistance distance;
  EXPECT_FALSE(distance.knowsTime());
  EXPECT_EQ(distance.choose(1e-6, 1.0, 10.0), 1.0);
}

TEST(SampleDistance, AllRaysIfThereIsTime)
{
  SampleDistance distance;
  distance.drawn(1.0, 2.0);
  EXPECT_TRUE(distance.knowsTime());
  EXPECT_EQ(distance.choose(2.0, 1.0, 10.0), 1.0);
  EXPECT_EQ(distance.choose(1e4, 1.0, 10.0), 1.0);
  EXPECT_EQ(distance.choose(0.0, 1.0, 10.0), 1.0); // no time is told
}

TEST(SampleDistance, TheLeastThatKeepsTheTime)
{
  for (const double full : { 0.11, 0.5, 3.0, 40.0 })
  {
    SampleDistance distance;
    const double d = settled(distance, full, 0.1);
    EXPECT_LE(full / (d * d), 0.1 * (1.0 + 1e-9)) << full;
    EXPECT_GT(full / (d * d), 0.1 / 2.0 * (1.0 - 1e-9)) << full;
    const double steps = 2.0 * std::log2(d);
    EXPECT_NEAR(steps, std::round(steps), 1e-9) << full;
  }
}

TEST(SampleDistance, WithinLimits)
{
  SampleDistance distance;
  distance.drawn(1.0, 1000.0);
  EXPECT_EQ(distance.choose(0.1, 1.0, 10.0), 10.0);
  EXPECT_EQ(distance.choose(1e6, 3.0, 10.0), 3.0);
  EXPECT_EQ(distance.choose(0.1, 4.0, 2.0), 4.0); // the least wins
}

// Times that go up and down a little don't change it back and forth.
TEST(SampleDistance, KeepsStill)
{
  SampleDistance distance;
  const double d = settled(distance, 0.385, 0.1); // a little less would do with the next step
  EXPECT_EQ(d, 2.0);
  for (const double noise : { 0.99, 1.01, 0.95, 0.9, 1.03 })
  {
    distance.drawn(d, noise * 0.385 / (d * d));
    EXPECT_EQ(distance.choose(0.1, 1.0, 100.0), d) << noise;
  }
  for (const double noise : { 0.5, 0.52, 0.49, 0.53 }) // could do with one step less, but barely
  {
    distance.drawn(d, noise * 0.385 / (d * d));
    EXPECT_EQ(distance.choose(0.1, 1.0, 100.0), d) << noise;
  }
  distance.drawn(d, 0.3 * 0.385 / (d * d));
  EXPECT_LT(distance.choose(0.1, 1.0, 100.0), d);
}
} // namespace
