// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether triangles stand in the way of rays, against VTK's locator and closed forms.
#include "Light/TriangleHierarchy.h"

#include "Ball.h"

#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace
{
using tetmarch::TriangleHierarchy;
using tetmarch::Vector3;
using tetmarch::operator-;
using tetmarch::testing::Ball;

constexpr double Inf = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

class Random
{
public:
  double number(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Engine()) / 4294967296.0);
  }
  Vector3 point(double low, double high)
  {
    return { { this->number(low, high), this->number(low, high), this->number(low, high) } };
  }

private:
  std::mt19937 Engine{ 1 };
};

TriangleHierarchy hierarchyOf(const Ball& ball) { return { ball.Points, ball.Triangles }; }

TEST(TriangleHierarchy, IsHitWhereVTKsLocatorFindsAnything)
{
  Random random;
  std::vector<Vector3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (std::uint32_t t = 0; t < 1000; ++t)
  {
    const Vector3 middle = random.point(0.0, 1.0);
    for (int i = 0; i < 3; ++i)
    {
      points.push_back(random.point(-0.06, 0.06));
      tetmarch::add(1.0, middle, points.back());
      places->InsertNextPoint(points.back().data());
    }
    triangles.push_back({ { 3 * t, 3 * t + 1, 3 * t + 2 } });
    cells->InsertNextCell({ 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  data->SetPoints(places);
  data->SetPolys(cells);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(data);
  locator->BuildLocator();
  const TriangleHierarchy hierarchy(points, triangles);
  vtkNew<vtkGenericCell> cell;
  int hits = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Vector3 from = random.point(-1.0, 2.0);
    const Vector3 to = random.point(-1.0, 2.0);
    double t, x[3], coordinates[3];
    int part;
    vtkIdType found;
    const bool expected = locator->IntersectWithLine(
                            from.data(), to.data(), 0.0, t, x, coordinates, part, found, cell) != 0;
    ASSERT_EQ(hierarchy.isHit(from, to - from, 1.0), expected) << "ray " << i;
    hits += expected ? 1 : 0;
  }
  EXPECT_GT(hits, 2000);
  EXPECT_LT(hits, 18000);
}

// Nor at corners and edges, which rays hit exactly as far as numbers can tell.
TEST(TriangleHierarchy, NothingSlipsOutOfAClosedSurface)
{
  const Ball ball(37, 53);
  const TriangleHierarchy hierarchy = hierarchyOf(ball);
  Random random;
  const auto expectCaught = [&](const Vector3& from, const Vector3& to)
  {
    ASSERT_TRUE(hierarchy.isHit(from, to - from, Inf));
    // Half of the way in is still inside, and so is twice the way out.
    ASSERT_FALSE(hierarchy.isHit(from, to - from, 0.4));
    ASSERT_FALSE(hierarchy.isHit(from, tetmarch::scaled(-1.0, to - from), 0.2));
  };
  for (int i = 0; i < 20000; ++i)
  {
    const Vector3 from = random.point(-0.1, 0.1);
    const auto& face = ball.Triangles[i % ball.Triangles.size()];
    expectCaught(from, ball.Points[face[0]]);
    const double share = random.number(0.0, 1.0);
    Vector3 onEdge = tetmarch::scaled(share, ball.Points[face[0]]);
    tetmarch::add(1.0 - share, ball.Points[face[1]], onEdge);
    expectCaught(from, onEdge);
    expectCaught({ { 0.0, 0.0, 0.0 } }, onEdge);
    const Vector3 outside = tetmarch::scaled(1.001, ball.Points[face[0]]);
    ASSERT_FALSE(hierarchy.isHit(outside, outside, Inf));
  }
}

TEST(TriangleHierarchy, BetweenTheEndsOfTheRay)
{
  const TriangleHierarchy hierarchy(
    { { { 0.0, 0.0, 2.0 } }, { { 1.0, 0.0, 2.0 } }, { { 0.0, 1.0, 2.0 } } }, { { { 0, 1, 2 } } });
  const Vector3 from{ { 0.25, 0.25, 0.0 } };
  EXPECT_TRUE(hierarchy.isHit(from, { { 0.0, 0.0, 1.0 } }, Inf));
  EXPECT_TRUE(hierarchy.isHit(from, { { 0.0, 0.0, 1.0 } }, 2.001));
  EXPECT_FALSE(hierarchy.isHit(from, { { 0.0, 0.0, 1.0 } }, 1.999));
  EXPECT_TRUE(hierarchy.isHit(from, { { 0.0, 0.0, 4.0 } }, 0.501)); // of any length
  EXPECT_FALSE(hierarchy.isHit(from, { { 0.0, 0.0, 4.0 } }, 0.499));
  EXPECT_FALSE(hierarchy.isHit(from, { { 0.0, 0.0, -1.0 } }, Inf));
  EXPECT_TRUE(hierarchy.isHit({ { 0.25, 0.25, 9.0 } }, { { 0.0, 0.0, -1.0 } }, Inf));
  EXPECT_FALSE(hierarchy.isHit({ { 0.75, 0.75, 0.0 } }, { { 0.0, 0.0, 1.0 } }, Inf));
  EXPECT_FALSE(hierarchy.isHit(from, { { 0.0, 0.0, 1.0 } }, 0.0));
}

TEST(TriangleHierarchy, WhateverItsSizeAndPlace)
{
  const Ball unit(12, 20);
  Random random;
  for (const double size : { 1e-12, 1.0, 1e9 })
  {
    for (const double offset : { 0.0, 1e6 * size })
    {
      Ball ball = unit;
      for (Vector3& p : ball.Points)
      {
        p = { { offset + size * p[0], offset + size * p[1], offset + size * p[2] } };
      }
      const TriangleHierarchy hierarchy = hierarchyOf(ball);
      for (int i = 0; i < 2000; ++i)
      {
        Vector3 from = random.point(-3.0, 3.0);
        Vector3 direction = random.point(-1.0, 1.0);
        const double along = tetmarch::dot(from, direction) / tetmarch::dot(direction, direction);
        Vector3 nearest = from;
        tetmarch::add(-along, direction, nearest);
        const double distance = std::sqrt(tetmarch::dot(nearest, nearest));
        const double radius = std::sqrt(tetmarch::dot(from, from));
        from = { { offset + size * from[0], offset + size * from[1], offset + size * from[2] } };
        // Between the ball and its triangles anything may be.
        if ((distance < 0.94 || distance > 1.0) && (radius < 0.94 || radius > 1.0))
        {
          ASSERT_EQ(hierarchy.isHit(from, tetmarch::scaled(size, direction), Inf),
            distance < 1.0 && (along < 0.0 || radius < 1.0))
            << size << ' ' << offset << ", ray " << i;
        }
      }
    }
  }
}

TEST(TriangleHierarchy, WhatIsNothingIsNotHit)
{
  const Vector3 from{ { 0.0, 0.0, 0.0 } };
  const Vector3 up{ { 0.0, 0.0, 1.0 } };
  EXPECT_FALSE(TriangleHierarchy({}, {}).isHit(from, up, Inf));
  const TriangleHierarchy flat(
    { { { 0.0, 0.0, 1.0 } }, { { 1.0, 0.0, 1.0 } }, { { -1.0, 0.0, 1.0 } } },
    { { { 0, 1, 2 } }, { { 0, 0, 0 } } });
  EXPECT_FALSE(flat.isHit(from, up, Inf));
  const TriangleHierarchy ball = hierarchyOf(Ball(8, 8));
  EXPECT_TRUE(ball.isHit(from, up, Inf));
  EXPECT_FALSE(ball.isHit(from, { { 0.0, 0.0, 0.0 } }, Inf));
  EXPECT_FALSE(ball.isHit(from, { { 0.0, NaN, 1.0 } }, Inf));
  EXPECT_FALSE(ball.isHit({ { NaN, 0.0, 0.0 } }, up, Inf));
  EXPECT_FALSE(ball.isHit({ { 0.0, 0.0, Inf } }, up, Inf));
  EXPECT_FALSE(ball.isHit(from, up, NaN));
}
} // namespace
