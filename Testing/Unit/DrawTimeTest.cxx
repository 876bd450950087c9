// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How long a draw call takes at most on simulated devices: drivers end what takes two seconds.
#include "SimulatedPictures.h"

#include "Budget/GrowingParts.h"

#include <cmath>
#include <random>

namespace
{
using namespace tetmarch::testing;
using tetmarch::GrowingParts;
using tetmarch::PictureContent;
using tetmarch::Tile;
using tetmarch::TileSchedule;

constexpr int Width = 3840;
constexpr int Height = 2160;
constexpr double Limit = 0.25;
constexpr double Longest = 0.5;
constexpr double Devices[] = { 0.1e-6, 0.3e-6, 1e-6, 5e-6, 20e-6 }; // seconds a pixel
const Tile All{ 0, 0, Width, Height };

// What is seen of a volume: its bounding box, and the pixels that cost something.
struct Scene
{
  const char* Name;
  Tile Box;
  Tile Dear;
  std::uintptr_t Version = 1;
  double Dearness = 1; // of the device's time of a pixel
};

Picture drawScene(TileSchedule& schedule, const Scene& scene, double secondsAPixel)
{
  return draw(schedule, Width, Height, Limit, within(scene.Dear, scene.Dearness * secondsAPixel),
    seenIn(scene.Box, Width, Height, scene.Version));
}

const Scene Full{ "full", All, All };
const Scene HalfEmpty{ "begins with an empty background", All,
  { 0, Height / 2, Width, Height / 2 } };
const Scene TopEmpty{ "ends with an empty background", All, { 0, 0, Width, Height / 2 } };
const Scene Spot{ "one dear place", All, { 1700, 900, 400, 400 } };
const Scene SpotInCorner{ "a dear place in the corner", All, { 3440, 1760, 400, 400 } };
const Scene Column{ "a dear column", { 1900, 0, 40, Height }, { 1900, 0, 40, Height } };
const Scene Far{ "far away", { 1900, 1060, 40, 40 }, { 1900, 1060, 40, 40 } };
const Scene Outside{ "out of the picture", { 4000, 900, 1000, 1000 }, { 0, 0, 0, 0 } };
const Scene Hidden{ "nothing is visible", All, { 0, 0, 0, 0 } };

TEST(DrawTime, OfTheFirstPicture)
{
  for (const Scene& scene :
    { Full, HalfEmpty, TopEmpty, Spot, SpotInCorner, Column, Far, Outside, Hidden })
  {
    for (const double device : Devices)
    {
      TileSchedule schedule;
      EXPECT_LE(drawScene(schedule, scene, device).Longest, Longest) << scene.Name << " " << device;
      EXPECT_LE(drawScene(schedule, scene, device).Longest, Longest) << scene.Name << " " << device;
    }
  }
}

TEST(DrawTime, AfterTheCameraHasJumped)
{
  const Scene scenes[] = { Full, HalfEmpty, TopEmpty, Spot, SpotInCorner, Column, Far, Outside };
  for (const Scene& before : scenes)
  {
    for (const Scene& after : scenes)
    {
      for (const double device : Devices)
      {
        for (const int pictures : { 1, 3, 20 })
        {
          TileSchedule schedule;
          for (int i = 0; i < pictures; ++i)
          {
            drawScene(schedule, before, device);
          }
          Scene jumped = after;
          jumped.Box.Width += 4 * Width; // the corners are far from where they were
          EXPECT_LE(drawScene(schedule, jumped, device).Longest, Longest)
            << before.Name << ", " << after.Name << " " << device;
        }
      }
    }
  }
}
// Data, functions, cuts, the unit distance.
TEST(DrawTime, AfterSomethingElseHasChanged)
{
  for (const Scene& before : { Full, Spot, Far, Hidden })
  {
    for (const Scene& after : { Full, HalfEmpty, Spot, SpotInCorner })
    {
      for (const double device : Devices)
      {
        for (const double dearness : { 1.0, 1.0 / 8, 1.0 / 32 })
        {
          TileSchedule schedule;
          Scene cheap = before;
          cheap.Dearness = dearness;
          drawScene(schedule, cheap, device);
          drawScene(schedule, cheap, device);
          Scene changed = after;
          changed.Version = 2;
          EXPECT_LE(drawScene(schedule, changed, device).Longest, Longest)
            << before.Name << ", " << after.Name << " " << device << " " << dearness;
        }
      }
    }
  }
}

// Towards the volume, around it and into it, in small steps.
TEST(DrawTime, WhileTheCameraMoves)
{
  for (const double device : Devices)
  {
    TileSchedule schedule;
    for (int i = 0; i <= 120; ++i)
    {
      const int size = static_cast<int>(40 * std::pow(1.03, i));
      const Tile box{ 6 * i, Height / 2 - size / 2, size, size };
      EXPECT_LE(drawScene(schedule, { "", box, box }, device).Longest, Longest) << i;
    }
    for (int x = -2000; x < Width; x += 60) // it comes in from the side
    {
      const Tile box{ x, 100, 1900, 1900 };
      EXPECT_LE(drawScene(schedule, { "", box, box }, device).Longest, Longest) << x;
    }
  }
}

TEST(DrawTime, OfRaysToManyDirections)
{
  for (const double device : { 0.1e-6, 20e-6 })
  {
    TileSchedule schedule;
    std::uintptr_t version = 0;
    for (const double rays : { 1.0, 1.0, 16.0, 64.0, 256.0, 3.0 })
    {
      PictureContent content;
      content.Version = { ++version };
      content.RaysPerPixel = rays;
      EXPECT_LE(draw(schedule, 4096, 256, Limit, even(rays * device), content).Longest, Longest)
        << rays;
    }
  }
}

// What this costs: tiles that are not needed.
TEST(DrawTime, FastPicturesAreFewTiles)
{
  TileSchedule schedule;
  constexpr double device = 20e-9;
  const Tile box{ 800, 100, 1900, 1900 };
  const auto drawn = [&](const Tile& seen, std::uintptr_t version) {
    return drawScene(schedule, { "", seen, seen, version }, device).Tiles;
  };
  EXPECT_LE(drawn(box, 1), 450); // nothing is known
  EXPECT_EQ(drawn(box, 1), 1);
  for (int i = 1; i < 60; ++i) // interaction
  {
    EXPECT_EQ(drawn({ 800 + 10 * i, 100 + i, 1900, 1900 }, 1), 1) << i;
  }
  EXPECT_LE(drawn({ 0, 0, 1900, 1900 }, 1), 30); // a jump
  EXPECT_LE(drawn({ 0, 0, 1900, 1900 }, 2), 30); // another function
  EXPECT_EQ(drawn({ 0, 0, 1900, 1900 }, 2), 1);
}

// A part of light is measured often enough, and nearly all of the time is spent in parts that are
// as long as they may be.
TEST(DrawTime, OfPartsThatGrow)
{
  constexpr double frame = 0.1;
  for (const double raysOfUnit : { 64.0, 64.0 * 17, 64.0 * 260 })
  {
    for (const double ray : { 1e-9, 0.1e-6, 1e-6, 20e-6 })
    {
      GrowingParts parts;
      parts.begin(raysOfUnit, frame);
      double longest = 0;
      double seconds = 0;
      int draws = 0;
      while (seconds < 50 * frame)
      {
        const double part = raysOfUnit * ray * static_cast<double>(parts.next());
        parts.done(parts.next(), part);
        longest = std::max(longest, part);
        seconds += part;
        ++draws;
      }
      EXPECT_LE(longest, Longest) << raysOfUnit << " " << ray;
      EXPECT_LE(draws, 50 * 8 + 32) << raysOfUnit << " " << ray; // today: by the hundred a frame
    }
  }
}

// The cost rises while parts are made: they get smaller at once.
TEST(DrawTime, OfPartsThatGetDearer)
{
  GrowingParts parts;
  parts.begin(64, 0.1);
  for (int i = 0; i < 30; ++i)
  {
    parts.done(parts.next(), 1e-9 * static_cast<double>(parts.next()));
  }
  const auto large = parts.next();
  for (int i = 0; i < 60; ++i)
  {
    parts.done(parts.next(), 1.0);
  }
  EXPECT_GT(large, 1000000);
  EXPECT_EQ(parts.next(), 8);
}
} // namespace
