// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What rays see of several components, against closed forms and a quadrature by VTK's own
// functions; and that they keep the tolerance, by a bound that holds.
#include "ClosedForms.h"
#include "ErrorTally.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// Of all rays against the quadrature.
template <typename Kernel, typename Real>
ErrorTally tallyOf(const ComponentRays& rays)
{
  ErrorTally tally;
  Kernel kernel = rays.kernel<Kernel, Real>();
  rays.Rays.forEachRay<Kernel, Real>(
    kernel, rays.Fields[0],
    [&](const typename Kernel::Ray& ray, const Chord& chord)
    {
      double bound = 0;
      const Rgba seen = pixelOf(kernel, ray, chord, bound);
      tally.add(seen, rays.byQuadrature(ray, chord), bound);
    },
    400);
  return tally;
}

template <template <typename> class Kernel>
void expectTolerance(int components, bool independent)
{
  for (const int cubes : { 1, 5 })
  {
    ComponentRays rays(jitteredLattice(cubes, 0.15), components, independent);
    for (const double tolerance : { 1.0 / 32.0, 1.0 / 255.0, 1.0 / 1024.0 })
    {
      AccuracyLevel level = levelOf(Accuracy::Default, tolerance);
      level.LeastTableEntries = 16384; // what is between entries is no part of the bound
      ASSERT_EQ(rays.use(level), "");
      const ErrorTally tally = tallyOf<Kernel<float>, float>(rays);
      std::cout << "[ MEASURED ] " << components << " components, " << cubes << "^3 cubes, 1/"
                << 1.0 / tolerance << ": worst " << tally.Worst / tolerance << " tolerances, bound "
                << tally.Bound / tally.Error << " times the error\n";
      EXPECT_GT(tally.Rays, 150);
      EXPECT_LE(tally.Worst, tolerance);
      EXPECT_LE(tally.BeyondBound, Rounding);
    }
    ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
    const ErrorTally exact = tallyOf<Kernel<double>, double>(rays);
    std::cout << "[ MEASURED ] in double: " << exact.Worst << '\n';
    EXPECT_LE(exact.Worst, 1e-5);
  }
}

TEST(ComponentMarch, TwoIndependentOnesKeepTheTolerance)
{
  expectTolerance<IndependentPointKernel>(2, true);
}
TEST(ComponentMarch, ThreeIndependentOnesKeepTheTolerance)
{
  expectTolerance<IndependentPointKernel>(3, true);
}
TEST(ComponentMarch, FourIndependentOnesKeepTheTolerance)
{
  expectTolerance<IndependentPointKernel>(4, true);
}
TEST(ComponentMarch, ColorAndOpacityKeepTheTolerance)
{
  expectTolerance<ColorAndOpacityPointKernel>(2, false);
}
TEST(ComponentMarch, DirectColorKeepsTheTolerance)
{
  expectTolerance<DirectColorPointKernel>(4, false);
}

// Pieces that are taken as they are promise nothing, but say by how much they may be off.
TEST(ComponentMarch, BoundsOfWhatIsTakenAsItIs)
{
  const auto expectBound = [](const ErrorTally& tally)
  {
    std::cout << "[ MEASURED ] fast: worst " << tally.Worst << ", bound "
              << tally.Bound / tally.Error << " times the error\n";
    EXPECT_LE(tally.BeyondBound, Rounding);
    EXPECT_GT(tally.Worst, 1e-3);
    EXPECT_LE(tally.Bound, 40 * tally.Error);
  };
  AccuracyLevel fast = levelOf(Accuracy::Fast, 1);
  fast.LeastTableEntries = fast.MostTableEntries = 16384;
  ComponentRays four(jitteredLattice(2, 0.15), 4, true);
  ASSERT_EQ(four.use(fast), "");
  expectBound(tallyOf<FastIndependentPointKernel<double>, double>(four));
  ComponentRays two(jitteredLattice(2, 0.15), 2, false);
  ASSERT_EQ(two.use(fast), "");
  expectBound(tallyOf<FastColorAndOpacityPointKernel<double>, double>(two));
  ComponentRays direct(jitteredLattice(2, 0.15), 4, false);
  ASSERT_EQ(direct.use(fast), "");
  expectBound(tallyOf<FastDirectColorPointKernel<double>, double>(direct));
}

// One colour after the other, in an even fog: what a slab of linear colour sends out.
TEST(ComponentMarch, ColorsThatAreLinearInAnEvenFog)
{
  ComponentRays rays(jitteredLattice(3, 0.15), 4, false);
  vtkNew<vtkPiecewiseFunction> even;
  even->AddPoint(0.0, 0.7);
  rays.Property->SetScalarOpacity(even);
  ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
  auto kernel = rays.kernel<DirectColorPointKernel<double>, double>();
  int checked = 0;
  rays.Rays.forEachRay<DirectColorPointKernel<double>, double>(kernel, rays.Fields[0],
    [&](const auto& ray, const Chord& chord)
    {
      const Rgba seen =
        BlendedRays::cast<DirectColorPointKernel<double>, double>(kernel, ray, chord);
      for (int k = 0; k < 3; ++k)
      {
        const Chord whole = rays.Rays.chordOf(ray, rays.Fields[k]);
        const double expected =
          slabColour(whole.scalarAt(chord.Begin), whole.scalarAt(chord.End), 0.7, chord.Optical);
        EXPECT_NEAR(seen[k], expected, 3e-6);
      }
      EXPECT_NEAR(seen[3], slabOpacity(0.7, chord.Optical), 3e-6);
      ++checked;
    });
  EXPECT_GT(checked, 200);
}

// Cells of constant scalars are exact: each ray sees the sum of what is in them.
template <template <typename> class Kernel>
void expectCells(int components, bool independent)
{
  ComponentRays rays(twoTetsSharingFace(), components, independent, true);
  ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
  auto kernel = rays.kernel<Kernel<double>, double>();
  RandomRays random(3);
  int checked = 0;
  for (int i = 0; i < 200; ++i)
  {
    const auto ray = random.next<Kernel<double>, double>(kernel, rays.Rays.Mesh);
    // A third of the opacity unit distance each.
    const auto march = kernel.castPlainRay(ray, -1, 3.0, -3.0, 3.0);
    const auto color = kernel.pixelOf(march.radiance, 3.0);
    // Whatever the depths of the cells, colours lie between those of both, and by their shares.
    std::array<Rgba, 2> media;
    for (int cell = 0; cell < 2; ++cell)
    {
      std::vector<double> tuple(components);
      rays.Data->GetCellData()->GetScalars()->GetTuple(cell, tuple.data());
      media[cell] = mediumAt(rays.Property, tuple);
    }
    if (march.cells == 1 && color.w > 1e-3)
    {
      const auto isMedium = [&](const Rgba& m)
      {
        return std::abs(color.x - m[0] / m[3] * color.w) < 1e-4 &&
               std::abs(color.y - m[1] / m[3] * color.w) < 1e-4 &&
               std::abs(color.z - m[2] / m[3] * color.w) < 1e-4;
      };
      EXPECT_TRUE(isMedium(media[0]) || isMedium(media[1]));
      ++checked;
    }
  }
  EXPECT_GT(checked, 20);
}

TEST(ComponentMarch, CellsHaveTheColorOfTheirMixture)
{
  expectCells<IndependentCellKernel>(2, true);
  expectCells<IndependentCellKernel>(4, true);
  expectCells<ColorAndOpacityCellKernel>(2, false);
  expectCells<DirectColorCellKernel>(4, false);
}
} // namespace
