// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays in large pages are arrays, however small or large.
#include "Parallel/HugePages.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;

TEST(HugePages, HoldValues)
{
  for (const std::size_t count : { 0u, 1u, 1000000u, 5000001u })
  {
    const auto filled = filledWith<std::uint32_t>(count, 7);
    EXPECT_EQ(filled.size(), count);
    EXPECT_EQ(std::count(filled.begin(), filled.end(), 7u), std::ptrdiff_t(count));
    const auto room = roomFor<double>(count);
    EXPECT_TRUE(room.empty());
    EXPECT_GE(room.capacity(), count);
  }
  preferHugePages(nullptr, 0);
}

} // namespace
