// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The ground truth of images and rectilinear grids where the scalar bends: closed forms of cubics,
// and the ground truth of tetrahedra.
#include "Grids.h"
#include "GroundTruth.h"
#include "LatticeImages.h"
#include "LatticeTruth.h"
#include "SelfTestModels.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr double Infinity = LatticeTruth::Infinity;
const Vec3 Zero = { 0.0, 0.0, 0.0 };
const Vec3 One = { 1.0, 1.0, 1.0 };
const double Diagonal = std::sqrt(3.0);

// The unit cube as an image of n cells along each edge, and as an uneven rectilinear grid.
std::vector<vtkSmartPointer<vtkDataSet>> cubesOf(const Field& field, int n)
{
  return { imageOf(field, unitCube(n)), rectilinearOf(field, unevenCube(n)) };
}

TEST(LatticeTruth, ProductAlongTheDiagonal)
{
  for (const int n : { 1, 3, 4 })
  {
    for (const auto& cube : cubesOf(productField(), n))
    {
      // Opacity 0.1 + 0.6 s^3: its mean is 0.1 + 0.6 / 4.
      OpticalModel model = ramps(One, One, 0.1, 0.7);
      model.UnitDistance = 0.2;
      const LatticeTruth thick(cube, model, LatticeValues::PointsLinear);
      EXPECT_NEAR(thick.depth(Zero, One), 0.25 / 0.2 * Diagonal, 1e-13);
      EXPECT_NEAR(thick.integrate({ 2.0, 2.0, 2.0 }, { -1.0, -1.0, -1.0 })[3],
        -std::expm1(-0.25 / 0.2 * Diagonal), 1e-13);
      const OpacitySums sums = thick.opacitySums(Zero, One);
      EXPECT_NEAR(sums.Length, Diagonal, 1e-14);
      EXPECT_NEAR(sums.Opacity, 0.25 * Diagonal, 1e-13);
      EXPECT_NEAR(sums.OpacityTimesScalar, (0.1 / 4.0 + 0.6 / 7.0) * Diagonal, 1e-13);
      // Up to s = 1/2, where the scalar is 1/8.
      const OpacitySums half = thick.opacitySums(Zero, One, -1.0, 0.125);
      EXPECT_NEAR(half.Length, 0.5 * Diagonal, 1e-14);
      EXPECT_NEAR(half.Opacity, (0.1 / 2.0 + 0.6 / 64.0) * Diagonal, 1e-13);

      // Colour s^3 at a constant extinction: the integral of D s^m exp(-D s) over [0, 1] is
      // m / D times that of m - 1, less exp(-D).
      model = ramps(Zero, One, 0.5, 0.5);
      const LatticeTruth coloured(cube, model, LatticeValues::PointsLinear);
      const double depth = 0.5 * Diagonal;
      double closed = -std::expm1(-depth);
      for (int m = 1; m <= 3; ++m)
      {
        closed = m / depth * closed - std::exp(-depth);
      }
      EXPECT_NEAR(coloured.integrate(Zero, One)[0], closed, 1e-13);
    }
  }
}

TEST(LatticeTruth, ProductAlongAnyRay)
{
  std::mt19937 generator(31);
  for (const auto& cube : cubesOf(productField(), 5))
  {
    const LatticeTruth truth(cube, ramps(One, One, 0.0, 1.0), LatticeValues::PointsLinear);
    for (int i = 0; i < 200; ++i)
    {
      const Vec3 a = randomPoint(generator, 0.0, 1.0);
      const Vec3 b = randomPoint(generator, 0.0, 1.0);
      const Vec3 d = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
      const double length = std::hypot(d[0], d[1], d[2]);
      // The mean of (a0 + d0 u) (a1 + d1 u) (a2 + d2 u) for u from 0 to 1.
      const double mean = a[0] * a[1] * a[2] +
                          (a[0] * a[1] * d[2] + a[0] * d[1] * a[2] + d[0] * a[1] * a[2]) / 2.0 +
                          (a[0] * d[1] * d[2] + d[0] * a[1] * d[2] + d[0] * d[1] * a[2]) / 3.0 +
                          d[0] * d[1] * d[2] / 4.0;
      ASSERT_NEAR(truth.depth(a, d, 0.0, length), mean * length, 1e-14);
    }
  }
}

TEST(LatticeTruth, ExtremesWithinACell)
{
  // On the diagonal 2 s - 2 s^2.
  const auto saddle =
    imageOf([](double x, double y, double) { return x + y - 2.0 * x * y; }, unitCube(1));
  const LatticeTruth truth(saddle, spiky(), LatticeValues::PointsLinear);
  const auto extremes = truth.extremes(Zero, One);
  EXPECT_NEAR((*extremes)[0], 0.0, 1e-15);
  EXPECT_NEAR((*extremes)[1], 0.5, 1e-15);
  EXPECT_FALSE(truth.extremes({ 2.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }));
}

TEST(LatticeTruth, ThreeCrossingsInACell)
{
  // The blossom of (s - 0.2) (s - 0.5) (s - 0.8): that on the diagonal, and linear in x, y and z
  // each (Ramshaw, "Blossoms are polar forms", 1989).
  const Field blossom = [](double x, double y, double z)
  { return x * y * z - 0.5 * (x * y + y * z + z * x) + 0.22 * (x + y + z) - 0.08; };
  for (const int n : { 1, 2, 5 })
  {
    OpticalModel model = ramps(Zero, One, 0.25, 0.25);
    model.Colour->AddRGBPoint(0.0, 0.2, 0.4, 0.6);
    const LatticeTruth truth(imageOf(blossom, unitCube(n)), model, LatticeValues::PointsLinear);
    const auto crossings = truth.crossings(Zero, One, { 0.0 });
    ASSERT_EQ(crossings.size(), 3u) << n;
    EXPECT_NEAR(crossings[0].T, 0.2 * Diagonal, 1e-14);
    EXPECT_NEAR(crossings[1].T, 0.5 * Diagonal, 1e-14);
    EXPECT_NEAR(crossings[2].T, 0.8 * Diagonal, 1e-14);
    const auto seen = truth.isosurfaces(Zero, One, { 0.0 });
    EXPECT_NEAR(seen[3], 1.0 - 0.75 * 0.75 * 0.75, 1e-14);
    EXPECT_NEAR(seen[1], 0.4 * seen[3], 1e-14);
    EXPECT_EQ(truth.crossings(Zero, One, { 0.0 }, 0.3 * Diagonal, 0.7 * Diagonal).size(), 1u);
  }
}

TEST(LatticeTruth, ASurfaceInFacesAndVerticesIsMetOnce)
{
  std::mt19937 generator(32);
  for (const auto& cube : cubesOf(linearFieldAlong(1.0, 1.0, 0.5), 10))
  {
    const LatticeTruth truth(cube, spiky(), LatticeValues::PointsLinear);
    for (int i = 0; i < 1000; ++i)
    {
      // Every other ray begins in a vertex and follows an edge or a diagonal.
      const bool even = i % 2 == 0;
      const Vec3 o = even ? Vec3{ i / 2 % 4 / 10.0, i / 8 % 4 / 10.0, i / 32 % 4 / 10.0 }
                          : randomPoint(generator, 0.0, 1.0);
      const Vec3 d = even ? Vec3{ 1.0, i / 2 % 2 * 1.0, i / 4 % 2 * 1.0 }
                          : Vec3{ uniform(generator), 0.2, uniform(generator) };
      const std::vector<ScalarSegment> segments = truth.segments(o, d);
      for (const ScalarSegment& segment : segments)
      {
        const double value = segment.Scalar.at(1.0);
        const bool isAhead = value > segments.front().Scalar.at(0.0);
        ASSERT_EQ(truth.crossings(o, d, { value }).size(), isAhead ? 1u : 0u);
      }
    }
  }
  const LatticeTruth cells(
    imageOf(linearField(), unitCube(4)), spiky(), LatticeValues::CellsNearest);
  EXPECT_TRUE(cells.crossings(Zero, One, { 0.5 }).empty());
}

TEST(LatticeTruth, AFaceThatRoundsOtherwiseOnItsSidesHidesNoSurface)
{
  const LatticeTruth truth(
    imageOf(noiseField(3, 20), unitCube(20)), spiky(), LatticeValues::PointsLinear);
  std::mt19937 generator(36);
  int rounded = 0;
  for (int i = 0; i < 10000; ++i)
  {
    const Vec3 o = randomPoint(generator, 0.0, 1.0);
    const Vec3 d = randomDirection(generator);
    const std::vector<ScalarSegment> segments = truth.segments(o, d);
    for (std::size_t k = 1; k < segments.size(); ++k)
    {
      const double before = segments[k - 1].Scalar.at(1.0);
      const double behind = segments[k].Scalar.at(0.0);
      if (before != behind)
      {
        ++rounded;
        const double value = std::max(before, behind);
        const bool reached = segments.front().Scalar.at(0.0) >= value;
        const bool reachedLast = segments.back().Scalar.at(1.0) >= value;
        ASSERT_EQ(truth.crossings(o, d, { value }).size() % 2, reached == reachedLast ? 0u : 1u);
      }
    }
  }
  EXPECT_GT(rounded, 5);
}

TEST(LatticeTruth, OfALinearFieldTetrahedraAreTheSame)
{
  std::mt19937 generator(34);
  for (const OpacityLaw law : { OpacityLaw::Linear, OpacityLaw::Logarithmic })
  {
    OpticalModel model = spiky();
    model.Law = law;
    const GroundTruthScene tetrahedra(jitteredLattice(5), model);
    for (const auto& cube : cubesOf(linearField(), 7))
    {
      const LatticeTruth lattice(cube, model, LatticeValues::PointsLinear);
      for (int i = 0; i < 50; ++i)
      {
        const Vec3 o = randomPoint(generator, -0.2, 1.2);
        const Vec3 d = randomDirection(generator);
        const auto expected = tetrahedra.integrate(o, d, -Infinity);
        const auto seen = lattice.integrate(o, d, -Infinity);
        for (int c = 0; c < 4; ++c)
        {
          ASSERT_NEAR(seen[c], expected[c], 1e-9);
        }
      }
    }
  }
}

TEST(LatticeTruth, DescendingCoordinatesAreTheMirrorImage)
{
  const AxisCoordinates up = unevenCube(4);
  AxisCoordinates down = up;
  std::reverse(down.Axes[1].begin(), down.Axes[1].end());
  const Field field = noiseField(7, 9);
  const auto mirrored = [&](double x, double y, double z) { return field(x, 1.0 - y, z); };
  std::mt19937 generator(35);
  for (const LatticeValues values : { LatticeValues::PointsLinear, LatticeValues::CellsLinear })
  {
    const LatticeTruth a(rectilinearOf(field, up), spiky(), values);
    const LatticeTruth b(rectilinearOf(mirrored, down), spiky(), values);
    for (int i = 0; i < 50; ++i)
    {
      const Vec3 o = randomPoint(generator, 0.0, 1.0);
      const Vec3 d = randomDirection(generator);
      ASSERT_NEAR(a.integrate(o, d)[0], b.integrate(o, d)[0], 1e-10);
    }
  }
}
} // namespace
