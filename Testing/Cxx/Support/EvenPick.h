// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What is picked of a cube of the same extinction everywhere, in closed form
 */
#ifndef tetmarch_testing_EvenPick_h
#define tetmarch_testing_EvenPick_h

#include "Mapper/MapperOptions.h"

#include "CpuReference.h"
#include "CutLine.h"
#include "PickScene.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace tetmarch::testing
{
constexpr double EvenExtinction = Even::Opacity / Even::UnitDistance;

/// The rasteriser's rounding moves a pixel's ray a little.
constexpr double RayTolerance = 1e-5;

inline double distance(const Vec3& a, const Vec3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The point at which a line has gathered the threshold's opacity. Missed if it leaves the cube
/// before that, Unsure if rounding decides.
struct ExpectedPick
{
  enum
  {
    Hit,
    Missed,
    Unsure
  } Kind;
  Vec3 Position;
};

/// Of the unit cube with the same extinction everywhere, less what is cut away.
inline ExpectedPick expectedOn(const PickScene::PixelLine& line, double threshold,
  double extinction = EvenExtinction, const tetmarch::ClippingOptions& cut = {})
{
  constexpr Vec3 Low{ 0.0, 0.0, 0.0 };
  constexpr Vec3 High{ 1.0, 1.0, 1.0 };
  const double ahead = boxChord(line.Near, line.Direction, Low, High, 0.0);
  // From the begin of the line to the cube.
  double begin = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    const double t0 = (Low[a] - line.Near[a]) / line.Direction[a];
    const double t1 = (High[a] - line.Near[a]) / line.Direction[a];
    begin = std::max(begin, std::min(t0, t1));
  }
  const Vec3 first = line.at(begin), last = line.at(begin + ahead);
  double missing = -std::log1p(-threshold) / extinction;
  ExpectedPick expected{ ExpectedPick::Missed, first };
  for (const auto& part : partsLeft(cut, { first, first }, { last, last }))
  {
    const double length = ahead * (part[1] - part[0]);
    if (std::abs(length - missing) < 1e-3 || (missing > 0.0 && missing < 1e-6))
    {
      return { ExpectedPick::Unsure, first };
    }
    if (expected.Kind == ExpectedPick::Missed && length > missing)
    {
      expected = { ExpectedPick::Hit, line.at(begin + ahead * part[0] + missing) };
      break;
    }
    missing -= length;
  }
  return expected;
}

/// Picks here and there in the renderer.
inline void expectClosedForm(PickScene& scene, double threshold, double tolerance, const char* what,
  double extinction = EvenExtinction)
{
  scene.Mapper->SetPickOpacityThreshold(threshold);
  const int* size = scene.Renderer->GetSize();
  const int* origin = scene.Renderer->GetOrigin();
  int hits = 0;
  int misses = 0;
  double worst = 0.0;
  for (int y = 7; y < size[1]; y += 13)
  {
    for (int x = 5; x < size[0]; x += 13)
    {
      const int column = origin[0] + x;
      const int row = origin[1] + y;
      const ExpectedPick expected = expectedOn(
        scene.lineOf(column, row), threshold, extinction, clippingOptionsOf(scene.Mapper.Get()));
      if (expected.Kind == ExpectedPick::Unsure)
      {
        continue;
      }
      const bool hit = scene.pick(column, row);
      ASSERT_EQ(hit, expected.Kind == ExpectedPick::Hit) << column << ", " << row;
      hits += hit ? 1 : 0;
      misses += hit ? 0 : 1;
      if (hit)
      {
        worst = std::max(worst, distance(scene.pickedPosition(), expected.Position));
      }
      else
      {
        ASSERT_TRUE(std::isnan(scene.pickedPosition()[0]));
        ASSERT_TRUE(std::isnan(scene.Mapper->GetPickedScalar()));
        ASSERT_EQ(scene.Mapper->GetPickedCellId(), -1);
      }
    }
  }
  EXPECT_LE(worst, tolerance) << what;
  EXPECT_GT(hits, 10) << what;
  std::cout << "[ MEASURED ] " << what << ", threshold " << threshold << ": " << hits
            << " points within " << worst << ", " << misses << " misses\n";
}
} // namespace tetmarch::testing

#endif
