// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march of dependent components through tetrahedra in light, against a quadrature and the light
// in closed form.
#include "Reference/LitColorAndOpacityCellKernel.h"
#include "Reference/LitColorAndOpacityPointGradientKernel.h"
#include "Reference/LitColorAndOpacityPointKernel.h"
#include "Reference/LitDirectColorCellKernel.h"
#include "Reference/LitDirectColorPointGradientKernel.h"
#include "Reference/LitDirectColorPointKernel.h"

#include "TetKinds.h"

#include <random>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

using Lit = Tetrahedra<LitComponentRays>;
using LitKinds = ::testing::Types<MarchKind<Lit, 2, false, LitColorAndOpacityPointKernel,
                                    LitColorAndOpacityPointKernel, LitColorAndOpacityCellKernel>,
  MarchKind<Lit, 4, false, LitDirectColorPointKernel, LitDirectColorPointKernel,
    LitDirectColorCellKernel>>;
INSTANTIATE_TYPED_TEST_SUITE_P(LitTetrahedra, MarchOf, LitKinds, KindNames);
INSTANTIATE_TYPED_TEST_SUITE_P(LitTetrahedra, CellsOf, LitKinds, KindNames);

// By the gradient of the component that the opacity comes from, at vertices or of cells.
template <template <typename> class Kernel>
void expectGradientOpacity(int components, bool cellGradients)
{
  LitComponentRays rays(jitteredLattice(3, 0.15), components);
  ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
  rays.addGradientOpacity();
  if (cellGradients)
  {
    rays.useCellGradients();
  }
  RayTally tally;
  tallyTruth<Kernel<double>>(tally, rays, 400);
  report("gradient opacity", tally);
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
template <typename Kernel>
void expectBoundOfChangingLight(int components)
{
  const Grid grid = jitteredLattice(3, 0.15);
  LitComponentRays rays(grid, components), exact(grid, components);
  for (LitComponentRays* each : { &rays, &exact })
  {
    std::mt19937 random(9);
    std::normal_distribution<float> normal;
    for (std::size_t i = 0; i < each->Rays.Mesh.Vertices.size(); ++i)
    {
      each->Effects.Gradients.push_back({ { normal(random), normal(random), normal(random) } });
    }
    each->Effects.Lights.SpecularPower = 3.0;
    each->blaze();
  }
  AccuracyLevel level = levelOf(Accuracy::Default, 1.0 / 64.0);
  level.LeastTableEntries = 16384;
  ASSERT_EQ(rays.use(level), "");
  ASSERT_EQ(exact.use(GroundTruthAccuracy), "");
  auto exactKernel = exact.kernel<Kernel>();
  RayTally tally;
  tallyRays(tally, rays, rays.kernel<Kernel>(), 400,
    [&](const auto& ray, const auto& part)
    { return pixelOf(exactKernel, marchOf(exactKernel, ray, part), part); });
  report("changing light", tally);
  EXPECT_GT(tally.Rays, 150);
  EXPECT_GT(tally.Worst, 1.0 / 64.0);
  EXPECT_LE(tally.BeyondBound, Rounding);
}

TEST(LitComponentMarch, BoundsOfChangingLight)
{
  expectBoundOfChangingLight<LitColorAndOpacityPointKernel<double>>(2);
  expectBoundOfChangingLight<LitDirectColorPointKernel<double>>(4);
}
} // namespace
