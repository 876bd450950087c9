// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures with made-up costs, for the schedule of their tiles.
#ifndef tetmarch_testing_SimulatedPictures_h
#define tetmarch_testing_SimulatedPictures_h

#include "Budget/TileSchedule.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

namespace tetmarch::testing
{
using SecondsOf = std::function<double(const Tile&)>;

struct Picture
{
  int Tiles = 0;
  double Seconds = 0;
  double Longest = 0;
};

// Draws a whole picture, and sees to it that its tiles have all of its pixels.
inline Picture draw(TileSchedule& schedule, int width, int height, double limit,
  const SecondsOf& secondsOf, const PictureContent& content = {},
  const std::function<void(const Tile&)>& seeTile = {})
{
  Picture picture;
  std::int64_t pixels = 0;
  double share = 0;
  Tile tile;
  schedule.begin(width, height, limit, content);
  while (schedule.next(tile))
  {
    if (seeTile)
    {
      seeTile(tile);
    }
    pixels += tile.pixels();
    const double seconds = secondsOf(tile);
    picture.Seconds += seconds;
    picture.Longest = std::max(picture.Longest, seconds);
    ++picture.Tiles;
    schedule.drawn(seconds);
    EXPECT_GT(schedule.share(), share);
    share = schedule.share();
    EXPECT_EQ(share == 1.0, schedule.finished());
  }
  EXPECT_EQ(pixels, std::int64_t(width) * height);
  EXPECT_EQ(picture.Tiles, schedule.numberOfTiles());
  return picture;
}

// All pixels alike.
inline SecondsOf even(double secondsAPixel)
{
  return [=](const Tile& tile) { return secondsAPixel * static_cast<double>(tile.pixels()); };
}

// Pixels of this rectangle alone cost something; each draw call does.
inline SecondsOf within(const Tile& box, double secondsAPixel)
{
  return [=](const Tile& tile)
  {
    const auto overlap = [](int a, int sizeA, int b, int sizeB)
    { return std::max(0, std::min(a + sizeA, b + sizeB) - std::max(a, b)); };
    return 1e-6 + secondsAPixel * overlap(tile.X, tile.Width, box.X, box.Width) *
                    overlap(tile.Y, tile.Height, box.Y, box.Height);
  };
}

// A volume whose bounding box covers a rectangle of the picture, in pixels.
inline PictureContent seenIn(const Tile& box, int width, int height, std::uintptr_t version = 1)
{
  PictureContent content;
  content.Version = { version };
  for (int i = 0; i < 8; ++i)
  {
    content.Corners[i] = { { 2.0 * (box.X + (i & 1 ? box.Width : 0)) / width - 1,
      2.0 * (box.Y + (i & 2 ? box.Height : 0)) / height - 1 } };
  }
  return content;
}
} // namespace tetmarch::testing

#endif
