// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The ground truth of images and rectilinear grids: lengths against boxes, colours against closed
// forms.
#include "ClosedForms.h"
#include "Grids.h"
#include "LatticeImages.h"
#include "LatticeTruth.h"
#include "SelfTestPlacedRay.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace
{
using namespace tetmarch::testing;

constexpr double Infinity = LatticeTruth::Infinity;
const Vec3 One = { 1.0, 1.0, 1.0 };

TEST(LatticeTruth, RefusesWhatIsNoVolume)
{
  const OpticalModel model = spiky();
  EXPECT_THROW(
    LatticeTruth(jitteredLattice(2), model, LatticeValues::PointsLinear), std::invalid_argument);
  ImagePlace flat = unitCube(4);
  flat.Extent[5] = 0;
  EXPECT_THROW(LatticeTruth(imageOf(linearField(), flat), model, LatticeValues::PointsLinear),
    std::invalid_argument);
  ImagePlace squashed = unitCube(4);
  squashed.Direction = { 1, 0, 0, 0, 1, 0, 0, 1, 0 };
  EXPECT_THROW(LatticeTruth(imageOf(linearField(), squashed), model, LatticeValues::PointsLinear),
    std::invalid_argument);
  const auto bare = imageOf(linearField());
  bare->GetPointData()->Initialize();
  EXPECT_THROW(LatticeTruth(bare, model, LatticeValues::PointsNearest), std::invalid_argument);
  EXPECT_NO_THROW(LatticeTruth(bare, model, LatticeValues::CellsNearest));
}

TEST(LatticeTruth, PathLengthIsTheChordOfTheVolume)
{
  std::mt19937 generator(21);
  for (const ImagePlace& place : imagePlaces())
  {
    const auto image = imageOf(linearField(), place);
    // What the rounding of a far origin leaves of the ray.
    const double tolerance = place.Name == "far origin" ? 1e-9 : 1e-12;
    for (const LatticeValues values : AllValues)
    {
      const LatticeTruth truth(image, spiky(), values);
      for (int i = 0; i < 500; ++i)
      {
        const PlacedRay ray = placedRay(image, generator);
        ASSERT_NEAR(truth.pathLength(ray.Origin, ray.Direction), ray.T1 - ray.T0, tolerance)
          << place.Name;
        ASSERT_NEAR(truth.pathLength(ray.Origin, ray.Direction, 0.0), ray.T1, tolerance)
          << place.Name;
      }
    }
  }
  for (const AxisCoordinates& axes : rectilinearAxes())
  {
    const auto grid = rectilinearOf(linearField(), axes);
    const double* b = grid->GetBounds();
    const double tolerance = axes.Name == "far from 0" ? 1e-9 : 1e-12;
    for (const LatticeValues values : AllValues)
    {
      const LatticeTruth truth(grid, spiky(), values);
      for (int i = 0; i < 500; ++i)
      {
        const Vec3 d = randomDirection(generator);
        Vec3 o = randomPoint(generator, -1.0, 2.0);
        for (int a = 0; a < 3; ++a)
        {
          o[a] = b[2 * a] + o[a] * (b[2 * a + 1] - b[2 * a]);
        }
        ASSERT_NEAR(truth.pathLength(o, d),
          boxChord(o, d, { b[0], b[2], b[4] }, { b[1], b[3], b[5] }), tolerance)
          << axes.Name;
      }
    }
  }
}

TEST(LatticeTruth, LinesInPlanesBelongToOneSide)
{
  // x + 10 y + 100 z of the cell.
  const auto image = imageOf(linearField(), { "", { 0, 4, 0, 4, 0, 4 } });
  vtkDataArray* cells = image->GetCellData()->GetScalars();
  for (vtkIdType i = 0; i < cells->GetNumberOfTuples(); ++i)
  {
    cells->SetComponent(i, 0, i % 4 + 10 * (i / 4 % 4) + 100 * (i / 16));
  }
  const LatticeTruth truth(image, spiky(), LatticeValues::CellsNearest);
  const auto valuesAlong = [&](const Vec3& o, const Vec3& d)
  {
    std::vector<double> values;
    for (const ScalarSegment& segment : truth.segments(o, d))
    {
      EXPECT_EQ(segment.Scalar.least(), segment.Scalar.greatest());
      values.push_back(segment.Scalar.at(0.5));
    }
    return values;
  };
  using Values = std::vector<double>;
  EXPECT_EQ(valuesAlong({ -1, 2, 2.5 }, { 1, 0, 0 }), Values({ 220, 221, 222, 223 }));
  EXPECT_EQ(valuesAlong({ -1, 2, 3 }, { 1, 0, 0 }), Values({ 320, 321, 322, 323 }));
  EXPECT_EQ(valuesAlong({ 5, 0, 4 }, { -2, 0, 0 }), Values({ 303, 302, 301, 300 }));
  EXPECT_EQ(valuesAlong({ 4, 4, 9 }, { 0, 0, -1 }), Values({ 333, 233, 133, 33 }));
  EXPECT_EQ(valuesAlong({ 4, 4.1, 9 }, { 0, 0, -1 }), Values());
  EXPECT_EQ(valuesAlong({ 0, 0, 0 }, One), Values({ 0, 111, 222, 333 }));
  EXPECT_EQ(valuesAlong({ 2, 0, 0 }, { 0, 1, 1 }), Values({ 2, 112, 222, 332 }));
}

TEST(LatticeTruth, ConstantField)
{
  std::mt19937 generator(22);
  for (const ImagePlace& place : imagePlaces())
  {
    const auto image = imageOf(constantField(0.3), place);
    OpticalModel model = ramps({ 0.0, 0.4, 1.0 }, { 1.0, 0.4, 0.0 }, 0.1, 0.9);
    model.UnitDistance = 1.7;
    for (const OpacityLaw law : { OpacityLaw::Linear, OpacityLaw::Logarithmic })
    {
      model.Law = law;
      const double opacity = 0.1 + 0.3 * 0.8;
      const double kappa = (law == OpacityLaw::Linear ? opacity : -std::log(1.0 - opacity)) / 1.7;
      for (const LatticeValues values : AllValues)
      {
        const LatticeTruth truth(image, model, values);
        for (int i = 0; i < 20; ++i)
        {
          const PlacedRay ray = placedRay(image, generator);
          const auto seen = truth.integrate(ray.Origin, ray.Direction, -Infinity);
          const double closed = slabOpacity(kappa, ray.T1 - ray.T0);
          ASSERT_NEAR(seen[3], closed, 1e-9);
          ASSERT_NEAR(seen[0], 0.3 * closed, 1e-9);
          ASSERT_NEAR(seen[1], 0.4 * closed, 1e-9);
          ASSERT_NEAR(
            truth.depth(ray.Origin, ray.Direction, -Infinity), kappa * (ray.T1 - ray.T0), 1e-9);
        }
      }
    }
  }
}

TEST(LatticeTruth, LinearFieldInAnyDirectionIsOneSegment)
{
  std::mt19937 generator(23);
  for (const ImagePlace& place : imagePlaces())
  {
    for (int i = 0; i < 50; ++i)
    {
      const Vec3 g = randomDirection(generator);
      const Field field = linearFieldAlong(g[0], g[1], g[2]);
      const auto image = imageOf(field, place);
      const PlacedRay ray = placedRay(image, generator);
      const double length = ray.T1 - ray.T0;
      const auto f = [&](double t)
      {
        const Vec3 p = ray.at(t);
        return field(p[0], p[1], p[2]);
      };
      const LatticeTruth thick(
        image, ramps({ 0.0, 0.0, 0.0 }, One, 0.1, 0.7), LatticeValues::PointsLinear);
      const auto kappa = [](double s) { return 0.1 + 0.6 * s; };
      ASSERT_NEAR(thick.integrate(ray.Origin, ray.Direction, -Infinity)[3],
        rampOpacity(kappa(f(ray.T0)), kappa(f(ray.T1)), length), 1e-9)
        << place.Name;
      const LatticeTruth coloured(
        image, ramps({ 0.0, 1.0, 0.5 }, { 1.0, 0.0, 0.5 }, 0.4, 0.4), LatticeValues::PointsLinear);
      const auto seen = coloured.integrate(ray.Origin, ray.Direction, -Infinity);
      ASSERT_NEAR(seen[0], slabColour(f(ray.T0), f(ray.T1), 0.4, length), 1e-9) << place.Name;
      ASSERT_NEAR(seen[1], slabColour(1 - f(ray.T0), 1 - f(ray.T1), 0.4, length), 1e-9);
      ASSERT_NEAR(seen[2], 0.5 * slabOpacity(0.4, length), 1e-9);
      const auto extremes = thick.extremes(ray.Origin, ray.Direction, -Infinity);
      ASSERT_NEAR((*extremes)[0], std::min(f(ray.T0), f(ray.T1)), 1e-9);
      ASSERT_NEAR((*extremes)[1], std::max(f(ray.T0), f(ray.T1)), 1e-9);
    }
  }
}
} // namespace
