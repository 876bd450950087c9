// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What rays see of dependent components in light, against a quadrature and the light in closed
// form; and that they keep the tolerance, by a bound that holds.
#include "Reference/LitColorAndOpacityCellKernel.h"
#include "Reference/LitColorAndOpacityPointGradientKernel.h"
#include "Reference/LitColorAndOpacityPointKernel.h"
#include "Reference/LitDirectColorCellKernel.h"
#include "Reference/LitDirectColorPointGradientKernel.h"
#include "Reference/LitDirectColorPointKernel.h"

#include "ComponentChecks.h"
#include "LitComponentRays.h"

#include <gtest/gtest.h>
#include <iostream>
#include <random>
#include <vector>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// Against the quadrature. density: the share of the extinction that is left.
template <typename Kernel, typename Real>
ErrorTally tallyOf(LitComponentRays& rays, double density = 1.0, bool cellGradients = false)
{
  return tallyRays<Kernel, Real>(rays, rays.litKernel<Kernel, Real>(cellGradients),
    [&](const auto& ray, ScalarChord chord)
    {
      chord.Optical *= density;
      return rays.lightOn(ray).of(rays.byQuadrature(ray, chord));
    });
}

template <template <typename> class Kernel>
void expectTolerance(int components)
{
  for (const int cubes : { 1, 5 })
  {
    LitComponentRays rays(jitteredLattice(cubes, 0.15), components);
    expectToleranceIsKept(
      rays, [&] { return tallyOf<Kernel<float>, float>(rays); },
      [&] { return tallyOf<Kernel<double>, double>(rays); });
  }
}

TEST(LitComponentMarch, ColorAndOpacityKeepTheTolerance)
{
  expectTolerance<LitColorAndOpacityPointKernel>(2);
}
TEST(LitComponentMarch, DirectColorKeepsTheTolerance)
{
  expectTolerance<LitDirectColorPointKernel>(4);
}

// Segments that are integrated whole promise nothing, but say by how much they may be off.
template <template <typename> class Kernel>
void expectBoundOfWholeSegments(int components)
{
  AccuracyLevel fast = levelOf(Accuracy::Fast, 1);
  fast.LeastTableEntries = fast.MostTableEntries = 16384;
  fast.MostTrials = 0;
  LitComponentRays rays(jitteredLattice(2, 0.15), components);
  rays.blaze();
  ASSERT_EQ(rays.use(fast), "");
  const ErrorTally tally = tallyOf<Kernel<double>, double>(rays);
  std::cout << "[ MEASURED ] " << tally << '\n';
  EXPECT_LE(tally.BeyondBound, Rounding);
  EXPECT_GT(tally.Worst, 1e-2);
  EXPECT_LE(tally.Bound, 40 * tally.Error);
}

TEST(LitComponentMarch, BoundsOfWhatIsTakenAsItIs)
{
  expectBoundOfWholeSegments<LitColorAndOpacityPointKernel>(2);
  expectBoundOfWholeSegments<LitDirectColorPointKernel>(4);
}

// By the gradient of the component that the opacity comes from, at vertices or of cells.
template <template <typename> class Kernel>
void expectGradientOpacity(int components, bool cellGradients)
{
  LitComponentRays rays(jitteredLattice(3, 0.15), components);
  ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
  const double density = rays.addGradientOpacity();
  const ErrorTally tally = tallyOf<Kernel<double>, double>(rays, density, cellGradients);
  std::cout << "[ MEASURED ] " << tally << '\n';
  EXPECT_GT(tally.Rays, 150);
  EXPECT_LE(tally.Worst, 1e-5);
}

TEST(LitComponentMarch, GradientOpacityIsByTheComponentOfTheOpacity)
{
  expectGradientOpacity<LitColorAndOpacityPointKernel>(2, false);
  expectGradientOpacity<LitDirectColorPointKernel>(4, false);
  expectGradientOpacity<LitColorAndOpacityPointGradientKernel>(2, true);
  expectGradientOpacity<LitDirectColorPointGradientKernel>(4, true);
}

// Where each vertex has a gradient of its own, light changes along a segment: the bound of that is
// kept, too, against segments as short as it takes.
template <template <typename> class Kernel>
void expectBoundOfChangingLight(int components)
{
  LitComponentRays rays(jitteredLattice(3, 0.15), components);
  std::mt19937 random(9);
  std::normal_distribution<float> normal;
  for (std::size_t i = 0; i < rays.Rays.Mesh.Vertices.size(); ++i)
  {
    rays.Effects.Gradients.push_back({ { normal(random), normal(random), normal(random) } });
  }
  rays.Effects.Lights.SpecularPower = 3.0;
  rays.blaze();
  std::vector<Rgba> exact;
  const auto forEach = [&](const AccuracyLevel& level, const auto& call)
  {
    ASSERT_EQ(rays.use(level), "");
    auto kernel = rays.litKernel<Kernel<double>, double>();
    rays.Rays.forEachRay<Kernel<double>, double>(
      kernel, rays.Fields[0],
      [&](const auto& ray, const ScalarChord& chord)
      {
        double bound = 0;
        const Rgba seen = pixelOf(kernel, ray, chord, bound);
        call(seen, bound);
      },
      400);
  };
  forEach(GroundTruthAccuracy, [&](const Rgba& seen, double) { exact.push_back(seen); });
  AccuracyLevel level = levelOf(Accuracy::Default, 1.0 / 64.0);
  level.LeastTableEntries = 16384;
  ErrorTally tally;
  forEach(
    level, [&](const Rgba& seen, double bound) { tally.add(seen, exact[tally.Rays], bound); });
  std::cout << "[ MEASURED ] " << tally << '\n';
  EXPECT_GT(tally.Rays, 150);
  EXPECT_GT(tally.Worst, 1.0 / 64.0);
  EXPECT_LE(tally.BeyondBound, Rounding);
}

TEST(LitComponentMarch, BoundsOfChangingLight)
{
  expectBoundOfChangingLight<LitColorAndOpacityPointKernel>(2);
  expectBoundOfChangingLight<LitDirectColorPointKernel>(4);
}

// Cells of constant scalars are exact: where a ray meets one alone, it has the colour of that in
// the light on it.
template <template <typename> class Kernel>
void expectCells(int components)
{
  LitComponentRays rays(twoTetsSharingFace(), components, true);
  ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
  const auto g = rays.gradient();
  rays.Effects.Gradients.assign(rays.Rays.Mesh.Vertices.size(),
    { { static_cast<float>(g[0]), static_cast<float>(g[1]), static_cast<float>(g[2]) } });
  expectColorsOfCells(rays, rays.litKernel<Kernel<double>, double>(), 1e-2,
    [&](const auto& ray, const Rgba& color) { return rays.lightOn(ray).of(color); });
}

TEST(LitComponentMarch, CellsHaveTheirColorInTheLight)
{
  expectCells<LitColorAndOpacityCellKernel>(2);
  expectCells<LitDirectColorCellKernel>(4);
}
} // namespace
