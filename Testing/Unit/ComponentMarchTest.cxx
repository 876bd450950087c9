// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What rays see of several components, against closed forms and a quadrature by VTK's own
// functions; and that they keep the tolerance, by a bound that holds.
#include "Reference/ColorAndOpacityCellKernel.h"
#include "Reference/ColorAndOpacityPointKernel.h"
#include "Reference/DirectColorCellKernel.h"
#include "Reference/DirectColorPointKernel.h"
#include "Reference/FastColorAndOpacityPointKernel.h"
#include "Reference/FastDirectColorPointKernel.h"
#include "Reference/FastIndependentPointKernel.h"
#include "Reference/IndependentCellKernel.h"
#include "Reference/IndependentPointKernel.h"

#include "ClosedForms.h"
#include "ComponentChecks.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// Against the quadrature.
template <typename Kernel, typename Real>
ErrorTally tallyOf(const ComponentRays& rays)
{
  return tallyRays<Kernel, Real>(rays, rays.kernel<Kernel, Real>(),
    [&](const auto& ray, const ScalarChord& chord) { return rays.byQuadrature(ray, chord); });
}

template <template <typename> class Kernel>
void expectTolerance(int components, bool independent)
{
  for (const int cubes : { 1, 5 })
  {
    ComponentRays rays(jitteredLattice(cubes, 0.15), components, independent);
    expectToleranceIsKept(
      rays, [&] { return tallyOf<Kernel<float>, float>(rays); },
      [&] { return tallyOf<Kernel<double>, double>(rays); });
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

// Segments that are integrated whole promise nothing, but say by how much they may be off.
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

// The colour changes linearly along the ray, the extinction is the same everywhere.
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
    [&](const auto& ray, const ScalarChord& chord)
    {
      const Rgba seen =
        BlendedRays::cast<DirectColorPointKernel<double>, double>(kernel, ray, chord);
      for (int k = 0; k < 3; ++k)
      {
        const ScalarChord whole = rays.Rays.chordOf(ray, rays.Fields[k]);
        const double expected =
          slabColour(whole.scalarAt(chord.Begin), whole.scalarAt(chord.End), 0.7, chord.Optical);
        EXPECT_NEAR(seen[k], expected, 3e-6);
      }
      EXPECT_NEAR(seen[3], slabOpacity(0.7, chord.Optical), 3e-6);
      ++checked;
    });
  EXPECT_GT(checked, 200);
}

// Cells of constant scalars are exact: a ray in one of them has the colour of its mixed components.
template <template <typename> class Kernel>
void expectCells(int components, bool independent)
{
  ComponentRays rays(twoTetsSharingFace(), components, independent, true);
  ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
  expectColorsOfCells(rays, rays.kernel<Kernel<double>, double>(), 1e-3,
    [](const auto&, const Rgba& color) { return color; });
}

TEST(ComponentMarch, CellsHaveTheColorOfTheirMixture)
{
  expectCells<IndependentCellKernel>(2, true);
  expectCells<IndependentCellKernel>(4, true);
  expectCells<ColorAndOpacityCellKernel>(2, false);
  expectCells<DirectColorCellKernel>(4, false);
}
} // namespace
