// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Tiles of pictures with made-up costs and a made-up clock.
#include "SimulatedPictures.h"

#include <limits>
#include <random>
#include <vector>

namespace
{
using namespace tetmarch::testing;
using tetmarch::PictureContent;
using tetmarch::Tile;
using tetmarch::TileSchedule;

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
    const int width = 1 + static_cast<int>(random() % 700);
    const int height = 1 + static_cast<int>(random() % 700);
    const double cost = 1e-9 * static_cast<double>(1 + random() % 100000);
    const double limit = i % 10 == 0 ? 0.0 : 1e-6 * static_cast<double>(random() % 100000);
    TileSchedule schedule;
    for (std::uintptr_t frame = 0; frame < 3; ++frame)
    {
      PictureContent content;
      content.Version = { frame / 2 };
      std::vector<int> drawn(std::size_t(width) * height, 0);
      draw(schedule, width, height, limit, even(cost), content,
        [&](const Tile& tile)
        {
          for (int y = tile.Y; y < tile.Y + tile.Height; ++y)
          {
            for (int x = tile.X; x < tile.X + tile.Width; ++x)
            {
              ++drawn.at(std::size_t(y) * width + x);
            }
          }
        });
      EXPECT_EQ(std::count(drawn.begin(), drawn.end(), 1), std::ptrdiff_t(drawn.size()));
    }
  }
}

TEST(TileSchedule, APictureThatFitsIsOneTile)
{
  TileSchedule schedule;
  const Picture first = draw(schedule, Width, Height, 0.25, even(0.2 / Pixels));
  EXPECT_GT(first.Tiles, 1);
  EXPECT_LT(first.Tiles, 60);
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
    EXPECT_LE(draw(schedule, Width, Height, 0.25, cost).Longest, 0.25);
    for (int frame = 0; frame < 4; ++frame)
    {
      const Picture picture = draw(schedule, Width, Height, 0.25, cost);
      EXPECT_LE(picture.Longest, 0.25);
      EXPECT_LE(picture.Tiles, 3 + 3 * 2 * seconds / 0.25);
    }
  }
}

TEST(TileSchedule, ItFollowsWhatNothingTells)
{
  TileSchedule schedule;
  draw(schedule, Width, Height, 0.25, even(0.1 / Pixels));
  EXPECT_EQ(draw(schedule, Width, Height, 0.25, even(1.0 / Pixels)).Tiles, 1);
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
  draw(schedule, Width, Height, 0.25, even(1.1 / Pixels));
  const int tiles = draw(schedule, Width, Height, 0.25, even(1.1 / Pixels)).Tiles;
  int calls = 0;
  draw(schedule, Width, Height, 0.25,
    [&](const Tile& tile) { return even(1.1 / Pixels)(tile) + (++calls == 2 ? 3.0 : 0.0); });
  draw(schedule, Width, Height, 0.25, even(1.1 / Pixels));
  EXPECT_EQ(draw(schedule, Width, Height, 0.25, even(1.1 / Pixels)).Tiles, tiles);
}

TEST(TileSchedule, TheFirstTileMayWaitForACompiler)
{
  TileSchedule schedule;
  int calls = 0;
  const SecondsOf compiled = [&](const Tile& tile)
  { return even(0.2 / Pixels)(tile) + (++calls == 1 ? 5.0 : 0.0); };
  EXPECT_LT(draw(schedule, Width, Height, 0.25, compiled).Tiles, 60);
  EXPECT_EQ(draw(schedule, Width, Height, 0.25, compiled).Tiles, 1);
}

TEST(TileSchedule, AnotherSizeTakesAsLongAPixel)
{
  TileSchedule schedule;
  draw(schedule, Width, Height, 0.25, even(0.1 / Pixels));
  EXPECT_EQ(draw(schedule, Width + 1, Height, 0.25, even(0.1 / Pixels)).Tiles, 1);
  const Picture larger = draw(schedule, 3 * Width, 2 * Height, 0.25, even(0.1 / Pixels));
  EXPECT_GT(larger.Tiles, 2);
  EXPECT_LE(larger.Longest, 0.25);
}

TEST(TileSchedule, ItBeginsAnewIfToldToForget)
{
  TileSchedule schedule;
  draw(schedule, Width, Height, 0.25, even(0.01 / Pixels));
  schedule.forget();
  EXPECT_LE(draw(schedule, Width, Height, 0.25, even(6.0 / Pixels)).Longest, 0.5);
}

// Such as peels of one picture.
TEST(TileSchedule, LayersMayCostWhatTheDearestDid)
{
  TileSchedule schedule;
  PictureContent layer;
  layer.IsLayer = true;
  draw(schedule, Width, Height, 0.25, even(1.0 / Pixels), layer);
  EXPECT_LE(draw(schedule, Width, Height, 0.25, even(0.001 / Pixels), layer).Longest, 0.25);
  EXPECT_LE(draw(schedule, Width, Height, 0.25, even(1.0 / Pixels), layer).Longest, 0.25);
}

// Pixels of a part of the picture, as of picks, may cost what those of another part did not.
TEST(TileSchedule, AnotherPartOfThePictureIsNotTheLast)
{
  TileSchedule schedule;
  PictureContent part;
  for (const int dear : { 1, 0, 1 })
  {
    part.Drawn = { { { 0.0, -1.0 + dear } }, { { 1.0, 0.0 + dear } } };
    EXPECT_LE(
      draw(schedule, Width, Height, 0.25, even((dear + 1e-3) / Pixels), part).Longest, 0.25);
  }
}

TEST(TileSchedule, APictureLeftUnfinishedIsNoMeasure)
{
  TileSchedule schedule;
  draw(schedule, Width, Height, 0.25, even(1.1 / Pixels));
  const int tiles = draw(schedule, Width, Height, 0.25, even(1.1 / Pixels)).Tiles;
  for (int i = 0; i < 3; ++i)
  {
    Tile tile;
    schedule.begin(Width, Height, 0.25, {});
    ASSERT_TRUE(schedule.next(tile));
    schedule.drawn(even(1.1 / Pixels)(tile));
    EXPECT_FALSE(schedule.finished());
  }
  EXPECT_EQ(draw(schedule, Width, Height, 0.25, even(1.1 / Pixels)).Tiles, tiles);
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
    schedule.begin(size.first, size.second, 0.25, {});
    EXPECT_FALSE(schedule.next(tile));
    EXPECT_TRUE(schedule.finished());
    EXPECT_EQ(schedule.numberOfTiles(), 0);
  }
}
} // namespace
