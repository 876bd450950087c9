// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics.h"

#include <gtest/gtest.h>

TEST(Statistics, Median)
{
  EXPECT_EQ(tetmarch::GetMedian({}), 0.0);
  EXPECT_EQ(tetmarch::GetMedian({ 3.0 }), 3.0);
  EXPECT_EQ(tetmarch::GetMedian({ 9.0, 1.0, 2.0 }), 2.0);
  EXPECT_EQ(tetmarch::GetMedian({ 8.0, 1.0, 2.0, 4.0 }), 3.0);
}
