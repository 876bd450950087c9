// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Pixel centres that meet vertices by construction, and eyes that sit on them.
#include "CaseAccess.h"
#include "CaseViews.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

Vec3 vec(const double* p) { return { p[0], p[1], p[2] }; }

Vec3 minus(const Vec3& a, const Vec3& b) { return { a[0] - b[0], a[1] - b[1], a[2] - b[2] }; }

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec3 unitCross(const Vec3& a, const Vec3& b)
{
  const Vec3 c = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0] };
  const double length = std::sqrt(dot(c, c));
  return { c[0] / length, c[1] / length, c[2] / length };
}

// Where a point falls in a square window: 0, 1, 2, ... are pixel centres.
std::array<double, 2> pixelOf(vtkCamera* camera, int pixels, const Vec3& point)
{
  const Vec3 direction = vec(camera->GetDirectionOfProjection());
  const Vec3 right = unitCross(direction, vec(camera->GetViewUp()));
  const Vec3 up = unitCross(right, direction);
  const Vec3 fromEye = minus(point, vec(camera->GetPosition()));
  const double half = camera->GetParallelProjection()
                        ? camera->GetParallelScale()
                        : std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())) *
                            dot(fromEye, direction);
  return { 0.5 * pixels * (1.0 + dot(fromEye, right) / half) - 0.5,
    0.5 * pixels * (1.0 + dot(fromEye, up) / half) - 0.5 };
}

bool isWhole(double x) { return std::abs(x - std::round(x)) < 1e-9; }

struct Hits
{
  int Columns = 0;  // points whose column is a pixel's
  int Centres = 0;  // points on pixel centres
  int InWindow = 0; // points in the window
  int Points = 0;
};

Hits hitsOf(const HardView& view, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkCamera> camera;
  view.Set(camera, grid);
  Hits hits;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const auto [x, y] = pixelOf(camera, view.Pixels, vec(grid->GetPoint(i)));
    const bool column = isWhole(x);
    ++hits.Points;
    hits.Columns += column;
    hits.Centres += column && isWhole(y);
    hits.InWindow += x > -0.5 - 1e-9 && x < view.Pixels - 0.5 + 1e-9 && y > -0.5 - 1e-9 &&
                     y < view.Pixels - 0.5 + 1e-9;
  }
  return hits;
}

bool isDiagonal(const HardView& view)
{
  return view.Name.find("down-110") == 0 || view.Name.find("down-111") == 0;
}

TEST(HardViews, PixelCentresAreLatticePoints)
{
  const HardCase& hard = caseOf("pixels-on-vertices");
  const Grid grid = hard.Make();
  EXPECT_EQ(hard.Views.size(), 12u);
  for (const HardView& view : hard.Views)
  {
    SCOPED_TRACE(view.Name);
    const Hits hits = hitsOf(view, grid);
    EXPECT_EQ(hits.InWindow, hits.Points);
    EXPECT_EQ(hits.Columns, hits.Points);
    if (isDiagonal(view))
    {
      EXPECT_GE(hits.Centres, 9);
    }
    else
    {
      EXPECT_EQ(hits.Centres, hits.Points);
    }
  }
}

TEST(HardViews, PixelCentresMissLatticePoints)
{
  for (const HardView& view : caseOf("pixels-on-edges").Views)
  {
    SCOPED_TRACE(view.Name);
    const Hits hits = hitsOf(view, caseOf("pixels-on-edges").Make());
    EXPECT_EQ(hits.Columns, hits.Points);
    EXPECT_LT(hits.Centres, isDiagonal(view) ? hits.Points / 4 : 1);
  }
  for (const HardView& view : caseOf("pixels-in-cells").Views)
  {
    EXPECT_EQ(hitsOf(view, caseOf("pixels-in-cells").Make()).Columns, 0) << view.Name;
  }
}

TEST(HardViews, FanGoesThroughVertices)
{
  const HardCase& hard = caseOf("fan-through-vertices");
  const Grid grid = hard.Make();
  EXPECT_EQ(hard.Views.size(), 3u);
  for (const HardView& view : hard.Views)
  {
    const Hits hits = hitsOf(view, grid);
    EXPECT_EQ(hits.InWindow, hits.Points);
    EXPECT_GE(hits.Centres, 2 * 81) << view.Name;
  }
}

TEST(HardViews, NeedlesAreSeenEndOn)
{
  const HardCase& hard = caseOf("needle-fan");
  const Grid grid = hard.Make();
  int endOn = 0;
  for (const HardView& view : hard.Views)
  {
    if (view.Pixels > 0)
    {
      vtkNew<vtkCamera> camera;
      view.Set(camera, grid);
      for (const vtkIdType end : { 0, 1 })
      {
        const auto [x, y] = pixelOf(camera, view.Pixels, vec(grid->GetPoint(end)));
        EXPECT_TRUE(isWhole(x) && isWhole(y)) << view.Name;
      }
      ++endOn;
    }
  }
  EXPECT_EQ(endOn, 3);
}

// The middle of a window has the same rays: what met a vertex still does.
TEST(HardViews, SmallWindowsHaveTheSameRays)
{
  for (const char* name : { "pixels-on-vertices", "pixels-on-edges", "fan-through-vertices" })
  {
    const Grid grid = caseOf(name).Make();
    for (const HardView& view : caseOf(name).Views)
    {
      SCOPED_TRACE(name + (": " + view.Name));
      const HardView small = inSmallWindow(view, 17);
      EXPECT_EQ(small.Pixels, view.Pixels == 64 ? 16 : 17);
      const Hits hits = hitsOf(small, grid);
      const Hits inLarge = hitsOf(view, grid);
      EXPECT_EQ(hits.Columns, inLarge.Columns);
      EXPECT_EQ(hits.Centres, inLarge.Centres);
      EXPECT_GT(hits.InWindow, 0);
      EXPECT_LT(hits.InWindow, inLarge.InWindow);
    }
  }
  const HardView any = inSmallWindow(standardViews().front(), 17);
  EXPECT_EQ(any.Pixels, 17);
}

TEST(HardViews, EyesSitOnLatticePoints)
{
  for (const HardView& view : caseOf("camera-in-lattice").Views)
  {
    vtkNew<vtkCamera> camera;
    view.Set(camera, caseOf("camera-in-lattice").Make());
    const Vec3 eye = vec(camera->GetPosition());
    // Vertices are multiples of 1/8, middles of edges of 1/16; the points in faces of 1/32.
    const double step = view.Name.find("vertex") != std::string::npos     ? 8.0
                        : view.Name.rfind("face") + 4 == view.Name.size() ? 32.0
                                                                          : 16.0;
    for (const double x : eye)
    {
      EXPECT_EQ(x * step, std::floor(x * step)) << view.Name;
      EXPECT_TRUE(x >= 0.0 && x <= 1.0);
    }
  }
  const HardCase& jittered = caseOf("camera-in-jittered-lattice");
  const Grid grid = jittered.Make();
  vtkNew<vtkCamera> camera;
  jittered.Views.front().Set(camera, grid);
  EXPECT_EQ(vec(camera->GetPosition()), vec(grid->GetPoint(3 + 9 * (4 + 9 * 3))));
}

TEST(HardViews, FarCamerasShowTheSameSize)
{
  const Grid grid = caseOf("camera-parallel").Make();
  for (const char* name : { "camera-at-10", "camera-at-1e3", "camera-at-1e6" })
  {
    vtkNew<vtkCamera> camera;
    caseOf(name).Views.front().Set(camera, grid);
    const double half =
      camera->GetDistance() * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
    EXPECT_NEAR(half, 0.45 * std::sqrt(3.0), 1e-9) << name;
    EXPECT_NEAR(camera->GetDistance() / std::stod(std::string(name).substr(10)), 1.0, 1e-6);
  }
}
} // namespace
