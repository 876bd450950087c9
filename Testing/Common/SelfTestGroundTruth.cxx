// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The ground truth by brute force: lengths against boxes, colours against closed forms, and what
// any order of colours must obey.
#include "ClosedForms.h"
#include "Grids.h"
#include "GroundTruth.h"
#include "SelfTestModels.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace
{
using namespace tetmarch::testing;

const Vec3 Zero = { 0.0, 0.0, 0.0 };
const Vec3 One = { 1.0, 1.0, 1.0 };
const Vec3 White = One;

// Along x through the unit cube on which the scalar is x.
const Field AlongX = [](double x, double, double) { return x; };

std::array<double, 4> seenAlongX(const OpticalModel& model)
{
  return GroundTruthScene(jitteredLattice(4, 0.15, 1, AlongX), model)
    .integrate({ -2.0, 0.4321, 0.5678 }, { 1.0, 0.0, 0.0 });
}

TEST(GroundTruth, RefusesOtherCellsAndMissingScalars)
{
  EXPECT_THROW(GroundTruthScene(hexLattice(2), spiky()), std::invalid_argument);
  const Grid bare = singleTet();
  bare->GetPointData()->Initialize();
  EXPECT_THROW(GroundTruthScene(bare, spiky()), std::invalid_argument);
  EXPECT_EQ(GroundTruthScene(bare, spiky(), ScalarsOf::Cells).pathLength(Zero, One) > 0.0, true);
}

TEST(GroundTruth, PathLengthIsTheChordOfTheCube)
{
  const GroundTruthScene scene(jitteredLattice(5), spiky());
  const RayChords chords(jitteredLattice(5));
  std::mt19937 generator(11);
  for (int i = 0; i < 10000; ++i)
  {
    const Vec3 origin = randomPoint(generator, -1.0, 2.0);
    const Vec3 direction = randomDirection(generator);
    ASSERT_NEAR(scene.pathLength(origin, direction), boxChord(origin, direction, Zero, One), 1e-13);
    ASSERT_NEAR(
      scene.pathLength(origin, direction, 0.0), boxChord(origin, direction, Zero, One, 0.0), 1e-13);
    double sum = 0.0;
    for (const Chord& chord : chords.find({ origin, direction }))
    {
      sum += chord.T1 - chord.T0;
    }
    ASSERT_NEAR(sum, boxChord(origin, direction, Zero, One), 1e-13);
  }
}

TEST(GroundTruth, PathLengthInFacesEdgesAndHoles)
{
  // Within faces and along edges of a plain lattice, where several cells claim the same chord.
  const GroundTruthScene plain(jitteredLattice(4, 0.0), spiky());
  EXPECT_NEAR(plain.pathLength({ -1.0, 0.25, 0.3 }, { 1.0, 0.0, 0.0 }), 1.0, 1e-15);
  EXPECT_NEAR(plain.pathLength({ -1.0, 0.25, 0.5 }, { 1.0, 0.0, 0.0 }), 1.0, 1e-15);
  EXPECT_NEAR(plain.pathLength({ -1.0, -1.0, -1.0 }, One), std::sqrt(3.0), 1e-15);

  const GroundTruthScene holed(latticeWithHole(6), spiky());
  const GroundTruthScene bored(latticeWithTunnel(6), spiky());
  const double b = holeBegin(6) / 6.0;
  const double e = holeEnd(6) / 6.0;
  std::mt19937 generator(12);
  for (int i = 0; i < 1000; ++i)
  {
    const Vec3 o = randomPoint(generator, 0.0, 1.0);
    const Vec3 d = randomDirection(generator);
    const double whole = boxChord(o, d, Zero, One);
    ASSERT_NEAR(holed.pathLength(o, d), whole - boxChord(o, d, { b, b, b }, { e, e, e }), 1e-13);
    ASSERT_NEAR(bored.pathLength(o, d), whole - boxChord(o, d, { b, b, 0 }, { e, e, 1 }), 1e-13);
  }
}

TEST(GroundTruth, PathLengthFarAwayAndRenumbered)
{
  const Grid mixed = shuffled(jitteredLattice(4), 3);
  const GroundTruthScene scene(mixed, spiky());
  const GroundTruthScene tiny(withOffsetAndScale(mixed, Zero, 1e-9), spiky());
  std::mt19937 generator(13);
  for (int i = 0; i < 200; ++i)
  {
    const Vec3 target = randomPoint(generator, 0.0, 1.0);
    const Vec3 d = randomDirection(generator);
    const Vec3 far = { target[0] - 1e6 * d[0], target[1] - 1e6 * d[1], target[2] - 1e6 * d[2] };
    // The direction's rounding moves the ray by 1e-10 there; a corner cut costs a few times that.
    ASSERT_NEAR(scene.pathLength(far, d), boxChord(target, d, Zero, One), 1e-8);
    const Vec3 small = { 1e-9 * target[0], 1e-9 * target[1], 1e-9 * target[2] };
    ASSERT_NEAR(1e9 * tiny.pathLength(small, d), boxChord(target, d, Zero, One), 1e-12);
  }
}

TEST(GroundTruth, ConstantSlab)
{
  for (const double opacity : { 0.0, 0.001, 0.3, 1.0 })
  {
    for (const double unit : { 10.0, 1.0, 0.01 })
    {
      OpticalModel model = ramps({ 0.2, 0.4, 0.8 }, { 0.2, 0.4, 0.8 }, opacity, opacity);
      model.UnitDistance = unit;
      auto seen = seenAlongX(model);
      const double linear = slabOpacity(opacity / unit, 1.0);
      EXPECT_NEAR(seen[3], linear, 1e-12);
      EXPECT_NEAR(seen[1], 0.4 * linear, 1e-12);
      model.Law = OpacityLaw::Logarithmic;
      model.MostOpacity = 0.999;
      seen = seenAlongX(model);
      const double kept = 1.0 - std::pow(1.0 - std::min(opacity, 0.999), 1.0 / unit);
      EXPECT_NEAR(seen[3], kept, 1e-12);
      EXPECT_NEAR(seen[2], 0.8 * kept, 1e-12);
    }
  }
}

TEST(GroundTruth, LinearRamps)
{
  for (const double unit : { 10.0, 1.0, 0.05, 0.002 })
  {
    OpticalModel model = ramps({ 0.9, 0.0, 0.3 }, { 0.1, 1.0, 0.3 }, 0.5, 0.5);
    model.UnitDistance = unit;
    auto seen = seenAlongX(model);
    EXPECT_NEAR(seen[0], slabColour(0.9, 0.1, 0.5 / unit, 1.0), 1e-11);
    EXPECT_NEAR(seen[1], slabColour(0.0, 1.0, 0.5 / unit, 1.0), 1e-11);
    EXPECT_NEAR(seen[2], slabColour(0.3, 0.3, 0.5 / unit, 1.0), 1e-11);

    model = ramps(White, White, 0.1, 0.7);
    model.UnitDistance = unit;
    seen = seenAlongX(model);
    EXPECT_NEAR(seen[3], rampOpacity(0.1 / unit, 0.7 / unit, 1.0), 1e-12);
    EXPECT_NEAR(seen[0], seen[3], 1e-12);
    // tau = C = x: the integral of x^2 exp(-x^2/2), which is sqrt(pi/2) erf(1/sqrt 2) - exp(-1/2).
    model = ramps(Zero, White, 0.0, 1.0);
    const double closed =
      std::sqrt(std::acos(-1.0) / 2.0) * std::erf(1.0 / std::sqrt(2.0)) - std::exp(-0.5);
    EXPECT_NEAR(seenAlongX(model)[0], closed, 1e-12);
  }
}

TEST(GroundTruth, LogarithmicRamp)
{
  // -ln(1 - x) up to x = a, then constant. Its integral is a + (1 - a) ln(1 - a) and then -(1 - a)
  // ln(1 - a): in all just a.
  for (const double a : { 0.3, 0.9, 1.0 - 1e-6 })
  {
    OpticalModel model = ramps(White, White, 0.0, 1.0);
    model.Law = OpacityLaw::Logarithmic;
    model.MostOpacity = a;
    model.UnitDistance = 0.25;
    EXPECT_NEAR(seenAlongX(model)[3], -std::expm1(-4.0 * a), 1e-12) << a;
  }
}

TEST(GroundTruth, WhiteIsAlphaAndSplittingChangesNothing)
{
  OpticalModel white = spiky();
  white.Colour->RemoveAllPoints();
  white.Colour->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  const Grid grid = jitteredLattice(5, 0.15, 1, noiseField());
  const GroundTruthScene whiteScene(grid, white);
  const GroundTruthScene scene(grid, spiky());
  const GroundTruthScene renumbered(shuffled(grid, 5), spiky());
  std::mt19937 generator(14);
  for (int i = 0; i < 30; ++i)
  {
    const Vec3 o = randomPoint(generator, 0.0, 1.0);
    const Vec3 d = randomDirection(generator);
    const Vec3 back = { -d[0], -d[1], -d[2] };
    const double infinity = GroundTruthScene::Infinity;
    const auto seen = whiteScene.integrate(o, d, -infinity);
    ASSERT_NEAR(seen[0], seen[3], 1e-10);
    // Transmittance is the same from both ends.
    ASSERT_NEAR(scene.depth(o, d, -infinity) / scene.depth(o, back, -infinity), 1.0, 1e-10);
    // Cut anywhere, then composited.
    const auto whole = scene.integrate(o, d, -infinity);
    const auto near = scene.integrate(o, d, -infinity, 0.1);
    const auto far = scene.integrate(o, d, 0.1);
    const auto other = renumbered.integrate(o, d, -infinity);
    for (int c = 0; c < 4; ++c)
    {
      ASSERT_NEAR(whole[c], near[c] + (1.0 - near[3]) * far[c], 1e-9);
      ASSERT_NEAR(whole[c], other[c], 1e-9);
    }
  }
}

TEST(GroundTruth, AgainstFineSampling)
{
  // Nothing in common with the quadrature: 400,000 midpoint steps in HSV and Lab, spikes and all.
  for (const bool lab : { false, true })
  {
    OpticalModel model = spiky();
    lab ? model.Colour->SetColorSpaceToLab() : model.Colour->SetColorSpaceToHSV();
    const auto seen = seenAlongX(model);
    std::array<double, 4> sum = { 0.0, 0.0, 0.0, 0.0 };
    const int steps = 400000;
    for (int i = 0; i < steps; ++i)
    {
      const double x = (i + 0.5) / steps;
      const double alpha = slabOpacity(model.extinction(x), 1.0 / steps);
      const Vec3 colour = model.colour(x);
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += (1.0 - sum[3]) * alpha * colour[c];
      }
      sum[3] += (1.0 - sum[3]) * alpha;
    }
    for (int c = 0; c < 4; ++c)
    {
      EXPECT_NEAR(seen[c], sum[c], 1e-8) << (lab ? "Lab " : "HSV ") << c;
    }
  }
}

TEST(GroundTruth, CellScalarsAndNotANumber)
{
  const Grid grid = jitteredLattice(4, 0.15, 1, noiseField());
  const OpticalModel model = spiky();
  const GroundTruthScene cells(grid, model, ScalarsOf::Cells);
  const Vec3 o = { -1.0, 0.3, 0.4 };
  const Vec3 d = { 1.0, 0.1, 0.05 };
  double depth = 0.0;
  for (const Chord& chord : RayChords(grid).find({ o, d }))
  {
    double f = grid->GetCellData()->GetScalars()->GetTuple1(chord.Cell);
    depth += (chord.T1 - chord.T0) * model.extinction(f);
  }
  EXPECT_NEAR(cells.integrate(o, d)[3], -std::expm1(-depth), 1e-12);

  grid->GetPointData()->GetScalars()->FillComponent(0, std::nan(""));
  const GroundTruthScene hidden(grid, model);
  EXPECT_EQ(hidden.integrate(o, d)[3], 0.0);
  EXPECT_GT(hidden.pathLength(o, d), 1.0);
}
} // namespace
