// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How far blocks are from what is seen, against all pairs of blocks; and what is seen of a range of
// scalars, against the table at many places.
#include "Structured/EmptySpace.h"

#include "LatticeGrids.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr ScalarRange Unit{ 0, 1, true };

// Entries with extinction, of a table whose stored scalars 0 and 1 are entries 2 and n - 3.
IntegralTable tableOf(const std::vector<float>& extinctions)
{
  IntegralTable table;
  for (const float extinction : extinctions)
  {
    table.Values.push_back({ { 0.5f, 0.5f, 0.5f, extinction } });
  }
  return table;
}

// With extinction from 0.5 on; at 0.5 itself there is none.
IntegralTable upperHalf() { return tableOf({ 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1 }); }

BlockRanges randomBlocks(const std::array<int, 3>& size, int seenIn, std::mt19937& random)
{
  BlockRanges ranges;
  ranges.Blocks = size;
  const std::size_t count = std::size_t(size[0]) * size[1] * size[2];
  for (std::size_t b = 0; b < count; ++b)
  {
    const bool seen = seenIn > 0 && random() % seenIn == 0;
    ranges.Scalars.push_back({ { 0.1f, seen ? 0.9f : 0.4f } });
  }
  return ranges;
}

std::array<int, 3> numbersOf(std::size_t b, const std::array<int, 3>& size)
{
  const int i = static_cast<int>(b);
  return { { i % size[0], i / size[0] % size[1], i / size[0] / size[1] } };
}

TEST(BlockDistances, AgainstAllPairs)
{
  std::mt19937 random(1);
  for (int n = 0; n < 60; ++n)
  {
    std::array<int, 3> size;
    for (int& side : size)
    {
      side = 1 + static_cast<int>(random() % 12);
    }
    const BlockRanges ranges = randomBlocks(size, n % 10 == 0 ? 0 : 1 << n % 11, random);
    const BlockDistances made = findBlockDistances(ranges, upperHalf(), Unit, false);
    ASSERT_EQ(made.Distances.size(), ranges.Scalars.size());
    EXPECT_EQ(made.Blocks, size);
    std::vector<std::array<int, 3>> seen;
    for (std::size_t b = 0; b < ranges.Scalars.size(); ++b)
    {
      if (ranges.Scalars[b][1] > 0.5f)
      {
        seen.push_back(numbersOf(b, size));
      }
    }
    for (std::size_t b = 0; b < ranges.Scalars.size(); ++b)
    {
      const auto at = numbersOf(b, size);
      int nearest = 255;
      for (const auto& other : seen)
      {
        nearest = std::min(nearest, std::max({ std::abs(at[0] - other[0]),
                                      std::abs(at[1] - other[1]), std::abs(at[2] - other[2]) }));
      }
      ASSERT_EQ(int(made.Distances[b]), nearest) << b << " of " << n;
    }
    EXPECT_DOUBLE_EQ(made.EmptyShare,
      1 - static_cast<double>(seen.size()) / static_cast<double>(ranges.Scalars.size()));
    EXPECT_DOUBLE_EQ(made.EmptyShare, transparentShare(ranges, upperHalf(), Unit));
  }
}

// Of several scalars a block is empty where none of them shows anything.
TEST(BlockDistances, OfSeveralScalars)
{
  const IntegralTable table = upperHalf();
  std::mt19937 random(7);
  const std::array<int, 3> size{ { 7, 5, 6 } };
  const BlockRanges first = randomBlocks(size, 8, random);
  const BlockRanges second = randomBlocks(size, 8, random);
  const BlockDistances one = findBlockDistances(first, table, Unit, false);
  const BlockDistances other = findBlockDistances(second, table, Unit, false);
  const BlockDistances both =
    findBlockDistances({ { &first, &table, Unit }, { &second, &table, Unit } }, false);
  int hiddenByOne = 0;
  for (std::size_t b = 0; b < both.Distances.size(); ++b)
  {
    ASSERT_EQ(both.Distances[b], std::min(one.Distances[b], other.Distances[b])) << b;
    hiddenByOne += one.Distances[b] > 0 && other.Distances[b] == 0 ? 1 : 0;
  }
  EXPECT_GT(hiddenByOne, 3);
  // What is not drawn is known of the first one.
  BlockRanges undrawn = first;
  undrawn.Undrawn.assign(undrawn.Scalars.size(), 1);
  EXPECT_EQ(
    findBlockDistances({ { &undrawn, &table, Unit }, { &second, &table, Unit } }, true).EmptyShare,
    0.0);
}

TEST(BlockDistances, AreAtMost255)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<int, 3> size{ { 1, 1, 1 } };
    size[axis] = 600;
    BlockRanges ranges;
    ranges.Blocks = size;
    ranges.Scalars.assign(600, { { 0.1f, 0.4f } });
    ranges.Scalars[20] = { { 0.1f, 0.9f } };
    const BlockDistances made = findBlockDistances(ranges, upperHalf(), Unit, false);
    for (int b = 0; b < 600; ++b)
    {
      ASSERT_EQ(int(made.Distances[b]), std::min(std::abs(b - 20), 255)) << b;
    }
  }
}

TEST(BlockDistances, WithoutBlocksThereAreNone)
{
  const BlockDistances made = findBlockDistances(BlockRanges{}, upperHalf(), Unit, true);
  EXPECT_TRUE(made.Distances.empty());
  EXPECT_EQ(made.EmptyShare, 0.0);
}

bool isSeen(
  const std::array<float, 2>& scalars, const IntegralTable& table, const ScalarRange& range = Unit)
{
  BlockRanges ranges;
  ranges.Blocks = { { 1, 1, 1 } };
  ranges.Scalars.push_back(scalars);
  return findBlockDistances(ranges, table, range, false).Distances[0] == 0;
}

double extinctionAt(const IntegralTable& table, double x)
{
  const double inside = std::clamp(x, 0.0, double(table.size() - 1));
  const int bin = std::min(static_cast<int>(inside), table.size() - 2);
  const double share = inside - bin;
  return double(table.Values[bin][3]) * (1 - share) + double(table.Values[bin + 1][3]) * share;
}

// Whether a table has extinction at one of many places between two scalars, entries included.
bool isSeenAtPlaces(
  const std::array<float, 2>& scalars, const IntegralTable& table, const ScalarRange& range)
{
  const double from = double(scalars[0]) * table.scale(range.width()) + table.offset(range.Low);
  const double to = double(scalars[1]) * table.scale(range.width()) + table.offset(range.Low);
  bool seen = extinctionAt(table, from) > 0 || extinctionAt(table, to) > 0;
  for (int i = -3; i < table.size() + 3; ++i)
  {
    for (const double x : { double(i), i + 0.5 })
    {
      seen = seen || (x >= from && x <= to && extinctionAt(table, x) > 0);
    }
  }
  return seen;
}

// Random tables with gaps, random ranges of scalars, some of which the table doesn't reach.
TEST(SeenBlocks, AgainstTheTableAtManyPlaces)
{
  std::mt19937 random(7);
  int seen = 0;
  constexpr int Count = 20000;
  for (int n = 0; n < Count; ++n)
  {
    std::vector<float> extinctions(6 + random() % 30);
    for (float& extinction : extinctions)
    {
      extinction = random() % 5 == 0 ? 0.5f : 0.0f;
    }
    const IntegralTable table = tableOf(extinctions);
    const double low = uniform(random) * 3 - 1.5;
    const ScalarRange range{ low, low + uniform(random) * 2, true };
    std::array<float, 2> scalars{ { static_cast<float>(uniform(random)),
      static_cast<float>(uniform(random)) } };
    scalars[1] = n % 3 == 0 ? scalars[0] : scalars[1];
    std::sort(scalars.begin(), scalars.end());
    const bool expected = isSeenAtPlaces(scalars, table, range);
    EXPECT_EQ(isSeen(scalars, table, range), expected) << n;
    seen += expected ? 1 : 0;
  }
  EXPECT_GT(seen, Count / 10);
  EXPECT_LT(seen, Count * 9 / 10);
}

// The most frequent empty space: values at an end of the range, from which on there is extinction.
TEST(SeenBlocks, EndsOfTheRangeAreNotRounded)
{
  for (const int samples : { 64, 257, 1000, 4093 })
  {
    std::vector<float> ramp(samples + 4, 1.0f);
    std::fill_n(ramp.begin(), 3, 0.0f); // up to the first sample
    EXPECT_FALSE(isSeen({ { 0, 0 } }, tableOf(ramp)));
    EXPECT_TRUE(isSeen({ { 0, 1e-7f } }, tableOf(ramp)));
    EXPECT_TRUE(isSeen({ { 0, 1 } }, tableOf(ramp)));
    std::reverse(ramp.begin(), ramp.end());
    EXPECT_FALSE(isSeen({ { 1, 1 } }, tableOf(ramp)));
    EXPECT_TRUE(isSeen({ { 1 - 1e-6f, 1 } }, tableOf(ramp)));
  }
}

// A scalar that a rounding of float separates from what is seen counts as seen.
TEST(SeenBlocks, InsideTheRangeScalarsMayBeRounded)
{
  const IntegralTable table = upperHalf(); // nothing up to 0.5
  EXPECT_TRUE(isSeen({ { 0.2f, 0.5f } }, table));
  EXPECT_TRUE(isSeen({ { 0.2f, std::nextafter(0.5f, 0.0f) } }, table));
  EXPECT_FALSE(isSeen({ { 0.2f, 0.499999f } }, table));
}

TEST(SeenBlocks, ByUndrawnValuesAndByNone)
{
  BlockRanges ranges;
  ranges.Blocks = { { 2, 1, 1 } };
  ranges.Scalars = { { { 1, 0 } }, { { 0.1f, 0.2f } } };
  ranges.Undrawn = { 1, 0 };
  EXPECT_EQ(findBlockDistances(ranges, upperHalf(), Unit, false).EmptyShare, 1.0);
  EXPECT_EQ(findBlockDistances(ranges, upperHalf(), Unit, true).Distances,
    (std::vector<std::uint8_t>{ 0, 1 }));
  // Not even where all is opaque.
  const IntegralTable opaque = tableOf(std::vector<float>(10, 1.0f));
  EXPECT_EQ(
    findBlockDistances(ranges, opaque, Unit, false).Distances, (std::vector<std::uint8_t>{ 1, 0 }));
}

TEST(SeenBlocks, BySurfaces)
{
  BlockRanges ranges;
  ranges.Blocks = { { 6, 1, 1 } };
  ranges.Scalars = { { { 0, 0.1f } }, { { 0.2f, 0.4f } }, { { 0.5f, 0.5f } }, { { 0.5f, 0.7f } },
    { { 1, 0 } }, { { 0.8f, 1 } } };
  const auto seenOf = [&](const std::vector<float>& values)
  {
    std::string seen;
    for (const std::uint8_t distance : findBlockDistances(ranges, values).Distances)
    {
      seen += distance == 0 ? 'x' : '-';
    }
    return seen;
  };
  EXPECT_EQ(seenOf({}), "------");
  EXPECT_EQ(seenOf({ 0.5f }), "--xx--");
  EXPECT_EQ(seenOf({ 0.15f, 0.45f, 0.75f }), "------");
  EXPECT_EQ(seenOf({ 0.0f, 0.3f, 1.0f }), "xx---x");
  EXPECT_EQ(seenOf({ -1.0f, 0.4f, 2.0f }), "-x----");
}
} // namespace
