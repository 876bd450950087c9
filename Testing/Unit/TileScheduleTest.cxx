// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Tiles of pictures with made-up costs and a made-up clock.
#include "Budget/TileSchedule.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

namespace
{
using tetmarch::Tile;
using tetmarch::TileSchedule;

using SecondsOf = std::function<double(const Tile&)>;

struct Picture
{
  int Tiles = 0;
  double Seconds = 0;
  double Longest = 0;
};

// Draws a whole picture and sees to it that each pixel is drawn once.
Picture draw(
  TileSchedule& schedule, int width, int height, double limit, const SecondsOf& secondsOf)
{
  Picture picture;
  std::vector<int> drawn(std::size_t(width) * height, 0);
  double share = 0;
  Tile tile;
  schedule.begin(width, height, limit);
  while (schedule.next(tile))
  {
    for (int y = tile.Y; y < tile.Y + tile.Height; ++y)
    {
      for (int x = tile.X; x < tile.X + tile.Width; ++x)
      {
        ++drawn.at(std::size_t(y) * width + x);
      }
    }
    const double seconds = secondsOf(tile);
    picture.Seconds += seconds;
    picture.Longest = std::max(picture.Longest, seconds);
    ++picture.Tiles;
    schedule.drawn(seconds);
    EXPECT_GT(schedule.share(), share);
    share = schedule.share();
    EXPECT_EQ(share == 1.0, schedule.finished());
  }
  EXPECT_EQ(std::count(drawn.begin(), drawn.end(), 1), std::ptrdiff_t(drawn.size()));
  EXPECT_EQ(picture.Tiles, schedule.numberOfTiles());
  return picture;
}

// All pixels alike.
SecondsOf even(double secondsAPixel)
{
  return [=](const Tile& tile) { return secondsAPixel * static_cast<double>(tile.pixels()); };
}

// Nothing but rows from a third of the height to two thirds costs anything.
SecondsOf uneven(int height, double secondsAPixel)
{
  return [=](const Tile& tile)
  {
    const int begin = std::max(tile.Y, height / 3);
    const int end = std::min(tile.Y + tile.Height, 2 * height / 3);
    return secondsAPixel * tile.Width * std::max(end - begin, 0) + 1e-6;
  };
}

constexpr int Width = 640;
constexpr int Height = 480;
constexpr double Pixels = Width * Height;

TEST(TileSchedule, EveryPixelOnce)
{
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i)
  {
    const int width = 1 + static_cast<int>(random() % 300);
    const int height = 1 + static_cast<int>(random() % 300);
    const double cost = 1e-9 * static_cast<double>(1 + random() % 100000);
    const double limit = i % 10 == 0 ? 0.0 : 1e-6 * static_cast<double>(random() % 100000);
    TileSchedule schedule;
    for (int frame = 0; frame < 3; ++frame)
    {
      draw(schedule, width, height, limit, even(cost));
    }
  }
}

TEST(TileSchedule, APictureThatFitsIsOneTile)
{
  TileSchedule schedule;
  const Picture first = draw(schedule, Width, Height, 0.25, even(0.2 / Pixels));
  EXPECT_GT(first.Tiles, 1);
  EXPECT_LT(first.Tiles, 24);
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_EQ(draw(schedule, Width, Height, 0.25, even(0.2 / Pixels)).Tiles, 1);
  }
}

TEST(TileSchedule, ASlowPictureIsSplitAsFarAsItTakes)
{
  for (const double seconds : { 0.3, 1.0, 5.0, 30.0 })
  {
    TileSchedule schedule;
    draw(schedule, Width, Height, 0.25, even(seconds / Pixels));
    for (int frame = 0; frame < 3; ++frame)
    {
      const Picture picture = draw(schedule, Width, Height, 0.25, even(seconds / Pixels));
      EXPECT_LE(picture.Longest, 0.25);
      EXPECT_LE(picture.Tiles, 2 + 2 * seconds / 0.25);
      EXPECT_GE(picture.Tiles, seconds / 0.25);
    }
  }
}

TEST(TileSchedule, WhereTheCostLiesDoesNotMatter)
{
  for (const double seconds : { 0.6, 3.0 })
  {
    TileSchedule schedule;
    const SecondsOf cost = uneven(Height, 3.0 * seconds / Pixels);
    // Of the first picture a tile may be the 16th part.
    EXPECT_LE(draw(schedule, Width, Height, 0.25, cost).Longest,
      std::max(0.25, 1.01 * 3.0 * seconds / 16.0));
    for (int frame = 0; frame < 4; ++frame)
    {
      const Picture picture = draw(schedule, Width, Height, 0.25, cost);
      EXPECT_LE(picture.Longest, 0.25);
      EXPECT_LE(picture.Tiles, 3 + 3 * 2 * seconds / 0.25);
    }
  }
}

TEST(TileSchedule, ItFollowsWhatChanges)
{
  TileSchedule schedule;
  draw(schedule, Width, Height, 0.25, even(0.1 / Pixels));
  EXPECT_EQ(draw(schedule, Width, Height, 0.25, even(1.0 / Pixels)).Tiles,
    1); // the first picture, of unknown cost
  EXPECT_LE(draw(schedule, Width, Height, 0.25, even(1.0 / Pixels)).Longest, 0.25);
  // Slower by the frame, and faster again.
  for (const double seconds : { 1.2, 1.5, 1.8, 2.2 })
  {
    EXPECT_LE(draw(schedule, Width, Height, 0.25, even(seconds / Pixels)).Longest, 1.25 * 0.25);
  }
  draw(schedule, Width, Height, 0.25, even(0.1 / Pixels));
  EXPECT_EQ(draw(schedule, Width, Height, 0.25, even(0.1 / Pixels)).Tiles, 1);
}

TEST(TileSchedule, ADisturbanceIsForgotten)
{
  TileSchedule schedule;
  draw(schedule, Width, Height, 0.25, even(1.0 / Pixels));
  const int tiles = draw(schedule, Width, Height, 0.25, even(1.0 / Pixels)).Tiles;
  int calls = 0;
  draw(schedule, Width, Height, 0.25,
    [&](const Tile& tile) { return even(1.0 / Pixels)(tile) + (++calls == 2 ? 3.0 : 0.0); });
  draw(schedule, Width, Height, 0.25, even(1.0 / Pixels));
  EXPECT_EQ(draw(schedule, Width, Height, 0.25, even(1.0 / Pixels)).Tiles, tiles);
}

TEST(TileSchedule, TheFirstTileMayWaitForACompiler)
{
  TileSchedule schedule;
  int calls = 0;
  const SecondsOf compiled = [&](const Tile& tile)
  { return even(0.2 / Pixels)(tile) + (++calls == 1 ? 5.0 : 0.0); };
  EXPECT_LT(draw(schedule, Width, Height, 0.25, compiled).Tiles, 24);
  EXPECT_EQ(draw(schedule, Width, Height, 0.25, compiled).Tiles, 1);
}

TEST(TileSchedule, TheFirstPictureMayBeginEmpty)
{
  TileSchedule schedule;
  const Picture picture = draw(schedule, Width, Height, 0.25,
    [](const Tile& tile) { return tile.Y < Height / 2 ? 0.0 : even(4.0 / Pixels)(tile); });
  EXPECT_LE(picture.Longest, 1.01 * 4.0 / 16.0);
}

TEST(TileSchedule, AnotherSizeIsAnotherPicture)
{
  TileSchedule schedule;
  draw(schedule, Width, Height, 0.25, even(0.1 / Pixels));
  EXPECT_GT(draw(schedule, Width + 1, Height, 0.25, even(0.1 / Pixels)).Tiles, 1);
  EXPECT_EQ(draw(schedule, Width + 1, Height, 0.25, even(0.1 / Pixels)).Tiles, 1);
}

TEST(TileSchedule, WhatMayHaveBecomeSlowIsTriedInParts)
{
  TileSchedule schedule;
  draw(schedule, Width, Height, 0.25, even(0.1 / Pixels));
  schedule.expectChange();
  EXPECT_LE(draw(schedule, Width, Height, 0.25, even(1.0 / Pixels)).Longest, 0.25);
  EXPECT_LE(draw(schedule, Width, Height, 0.25, even(1.0 / Pixels)).Tiles, 8);
  // Very fast pictures are drawn as one tile.
  draw(schedule, Width, Height, 0.25, even(0.01 / Pixels));
  schedule.expectChange();
  EXPECT_EQ(draw(schedule, Width, Height, 0.25, even(0.01 / Pixels)).Tiles, 1);
}

TEST(TileSchedule, APictureLeftUnfinishedIsNoMeasure)
{
  TileSchedule schedule;
  draw(schedule, Width, Height, 0.25, even(1.0 / Pixels));
  const int tiles = draw(schedule, Width, Height, 0.25, even(1.0 / Pixels)).Tiles;
  for (int i = 0; i < 3; ++i)
  {
    Tile tile;
    schedule.begin(Width, Height, 0.25);
    ASSERT_TRUE(schedule.next(tile));
    schedule.drawn(even(1.0 / Pixels)(tile));
    EXPECT_FALSE(schedule.finished());
  }
  EXPECT_EQ(draw(schedule, Width, Height, 0.25, even(1.0 / Pixels)).Tiles, tiles);
}

TEST(TileSchedule, WithoutALimitOneTile)
{
  for (const double limit : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    TileSchedule schedule;
    for (int frame = 0; frame < 2; ++frame)
    {
      EXPECT_EQ(draw(schedule, Width, Height, limit, even(1.0)).Tiles, 1);
    }
  }
}

TEST(TileSchedule, TilesStayLargeEnoughToBeWorthIt)
{
  TileSchedule schedule;
  for (int frame = 0; frame < 2; ++frame)
  {
    const Picture picture = draw(schedule, 320, 160, 1e-9, even(1.0));
    EXPECT_EQ(picture.Tiles, 10 * 5);
  }
}

TEST(TileSchedule, ClocksMayStandStill)
{
  TileSchedule schedule;
  for (int frame = 0; frame < 2; ++frame)
  {
    draw(schedule, Width, Height, 0.25, [](const Tile&) { return 0.0; });
  }
  EXPECT_EQ(draw(schedule, Width, Height, 0.25, even(0.0)).Tiles, 1);
}

TEST(TileSchedule, NothingToDrawIsNoTile)
{
  TileSchedule schedule;
  Tile tile;
  for (const auto& size : { std::pair(0, 5), std::pair(5, 0), std::pair(-3, -4), std::pair(-3, 4) })
  {
    schedule.begin(size.first, size.second, 0.25);
    EXPECT_FALSE(schedule.next(tile));
    EXPECT_TRUE(schedule.finished());
    EXPECT_EQ(schedule.numberOfTiles(), 0);
  }
}
} // namespace
