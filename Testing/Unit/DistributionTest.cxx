// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Figures of values over pixels.
#include "Diagnostics/Distribution.h"

#include <gtest/gtest.h>

namespace
{
using tetmarch::Distribution;

TEST(Distribution, OfSomeValues)
{
  const Distribution d({ 4.0f, 1.0f, 3.0f, 2.0f });
  EXPECT_EQ(d.size(), 4u);
  EXPECT_EQ(d.minimum(), 1.0);
  EXPECT_EQ(d.maximum(), 4.0);
  EXPECT_EQ(d.mean(), 2.5);
  EXPECT_DOUBLE_EQ(d.rootMeanSquare(), std::sqrt(7.5));
  EXPECT_EQ(d.percentile(0.0), 1.0);
  EXPECT_EQ(d.percentile(25.0), 1.0);
  EXPECT_EQ(d.percentile(25.1), 2.0);
  EXPECT_EQ(d.percentile(50.0), 2.0);
  EXPECT_EQ(d.percentile(75.1), 4.0);
  EXPECT_EQ(d.percentile(100.0), 4.0);
  EXPECT_EQ(d.percentile(-5.0), 1.0);
  EXPECT_EQ(d.percentile(500.0), 4.0);
}

TEST(Distribution, OfNone)
{
  const Distribution d;
  EXPECT_EQ(d.size(), 0u);
  EXPECT_EQ(d.minimum() + d.maximum() + d.mean() + d.rootMeanSquare() + d.percentile(50.0), 0.0);
}
} // namespace
