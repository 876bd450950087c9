// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Radiance through many cells where it has a closed form.
#include "Mesh/MeshScalars.h"
#include "Reference/CellKernel.h"
#include "Reference/PointKernel.h"

#include "ClosedForms.h"
#include "RandomRays.h"
#include "UnitMeshes.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// Along x through the middle of a unit cube whose scalar is x.
template <typename Kernel, typename Real>
typename Kernel::March alongX(
  const IntegralTable& table, const AccuracyLevel& level, double depthPerCube, const Grid& grid)
{
  TetMesh mesh = builtWithHierarchy(grid);
  readScalars(grid, { grid->GetPointData()->GetScalars() }, mesh);
  auto kernel = kernelOf<Kernel, Real>(mesh, table, level);
  const auto ray =
    kernel.rayThrough({ Real(0), Real(0.0123), Real(-0.0071) }, { Real(1), Real(0), Real(0) });
  return kernel.castPlainRay(
    ray, Real(depthPerCube * mesh.Frame.Radius), Real(-1e30f), Real(1e30f));
}

const Field AlongX = [](double x, double, double) { return x; };
const double Thicknesses[] = { 1e-4, 0.1, 1.0, 3.0, 6.0 };

// Transmittance is a product of one factor a cell. Float rounds each of them twice, and lengths by
// 16 eps.
TEST(Analytic, ConstantField)
{
  for (const double kappa : { 1e-6, 0.3, 1.0 })
  {
    const IntegralTable table = tableOf(
      [kappa](double) {
        return std::array<double, 4>{ { 0.2, 0.4, 0.8, kappa } };
      });
    for (const double thickness : Thicknesses)
    {
      const double opacity = slabOpacity(kappa * thickness, 1.0);
      const auto exact = alongX<PointKernel<double>, double>(
        table, GroundTruthAccuracy, thickness, jitteredLattice(5, 0.15, 1, constantField(0.5)));
      // kappa is stored as a float, and the series in meanTransmittance is good to 4e-8.
      EXPECT_NEAR(1.0 - exact.radiance.transmittance, opacity, 2e-7);
      EXPECT_NEAR(exact.radiance.color.z, 0.8 * opacity, 2e-7);
      const auto single = alongX<PointKernel<float>, float>(
        table, GroundTruthAccuracy, thickness, jitteredLattice(5, 0.15, 1, constantField(0.5)));
      const double bound = (2 * single.cells + 32) * std::ldexp(1.0, -24);
      EXPECT_NEAR(1.0 - double(single.radiance.transmittance), opacity, bound);
      EXPECT_NEAR(double(single.radiance.color.y), 0.4 * opacity, bound);
    }
  }
}

TEST(Analytic, LinearExtinction)
{
  const IntegralTable table = tableOf(
    [](double f) {
      return std::array<double, 4>{ { 1.0, 1.0, 1.0, 0.1 + 0.6 * f } };
    });
  for (const double thickness : Thicknesses)
  {
    const double opacity = rampOpacity(0.1 * thickness, 0.7 * thickness, 1.0);
    const auto exact = alongX<PointKernel<double>, double>(
      table, DefaultAccuracy, thickness, jitteredLattice(5, 0.15, 1, AlongX));
    // Positions, scalars and samples are floats.
    EXPECT_NEAR(1.0 - exact.radiance.transmittance, opacity, 4e-7);
    // White is as bright as it is opaque, however segments are split.
    EXPECT_NEAR(exact.radiance.color.x, opacity, 4e-7);
    const auto single = alongX<PointKernel<float>, float>(
      table, DefaultAccuracy, thickness, jitteredLattice(5, 0.15, 1, AlongX));
    EXPECT_NEAR(1.0 - double(single.radiance.transmittance), opacity,
      (4 * single.cells + 32) * std::ldexp(1.0, -24));
  }
}

TEST(Analytic, LinearColour)
{
  const IntegralTable table = tableOf(
    [](double f) {
      return std::array<double, 4>{ { 0.9 - 0.8 * f, f, 0.3, 0.5 } };
    });
  for (const double thickness : Thicknesses)
  {
    const auto march = alongX<PointKernel<double>, double>(
      table, GroundTruthAccuracy, thickness, jitteredLattice(5, 0.15, 1, AlongX));
    // Each lookup errs by 1e-6 at most.
    const double bound = 1e-6 * march.lookups + 4e-7;
    EXPECT_NEAR(march.radiance.color.x, slabColour(0.9, 0.1, 0.5 * thickness, 1.0), bound);
    EXPECT_NEAR(march.radiance.color.y, slabColour(0.0, 1.0, 0.5 * thickness, 1.0), bound);
    const auto fast = alongX<PointKernel<float>, float>(
      table, DefaultAccuracy, thickness, jitteredLattice(5, 0.15, 1, AlongX));
    EXPECT_NEAR(
      double(fast.radiance.color.y), slabColour(0.0, 1.0, 0.5 * thickness, 1.0), 1.0 / 255.0);
  }
}

// Scalars that are no numbers are passed through, and what they touch isn't drawn.
TEST(Analytic, NotANumberIsNothing)
{
  const Grid grid = jitteredLattice(4, 0.15, 1, constantField(std::nan("")));
  const auto march = alongX<PointKernel<float>, float>(whiteTable(), DefaultAccuracy, 1.0, grid);
  EXPECT_GT(march.cells, 4);
  EXPECT_EQ(march.radiance.transmittance, 1.0f);
  EXPECT_EQ(march.radiance.color.x, 0.0f);

  // The half x < 1/2 is not drawn, nor the cells that touch it.
  const Grid half = jitteredLattice(4, 0.0, 1, AlongX);
  vtkDataArray* values = half->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < half->GetNumberOfPoints(); ++i)
  {
    values->SetComponent(i, 0, half->GetPoint(i)[0] < 0.49 ? std::nan("") : 1.0);
  }
  const auto rest =
    alongX<PointKernel<double>, double>(whiteTable(), GroundTruthAccuracy, 1.0, half);
  EXPECT_NEAR(1.0 - rest.radiance.transmittance, slabOpacity(1.0, 0.5), 2e-7);
}

// The further a ray goes the less it sees; always numbers, always within 0..1.
TEST(Analytic, TransmittanceNeverGrows)
{
  const IntegralTable table = tableOf(
    [](double f) {
      return std::array<double, 4>{ { f, 1.0 - f, 0.5, f > 0.4 && f < 0.6 ? 1.0 : 0.1 * f } };
    });
  const Grid grid = jitteredLattice(5, 0.15, 1, noiseField());
  TetMesh mesh = builtWithHierarchy(grid);
  readScalars(grid, { grid->GetPointData()->GetScalars() }, mesh);
  auto kernel = kernelOf<PointKernel<float>, float>(mesh, table, DefaultAccuracy);
  for (const float thickness : { 0.1f, 3.0f, 1e3f, 1e6f })
  {
    RandomRays random(61);
    for (int i = 0; i < 200; ++i)
    {
      const auto ray = random.next<PointKernel<float>, float>(kernel, mesh);
      float before = 1.0f;
      for (float end = -1.0f; end < 1.1f; end += 0.07f)
      {
        const auto march = kernel.castPlainRay(ray, thickness, -1e30f, end);
        const float now = march.radiance.transmittance;
        // Where the ray ends, segments end: a few roundings. Below the level's tolerance a
        // ray is opaque, and it may get there later if its last segment was cut short.
        ASSERT_LE(now, std::max(before * (1.0f + 1e-5f), kernel.errorTolerance));
        ASSERT_GE(now, 0.0f);
        ASSERT_TRUE(march.radiance.color.x >= 0.0f && march.radiance.color.x <= 1.0f + 1e-6f);
        before = now;
      }
    }
  }
}

TEST(Analytic, ThinCellsTakeOneLookupEach)
{
  const IntegralTable table = tableOf(
    [](double f) {
      return std::array<double, 4>{ { f, 1.0 - f, 0.5 + 0.5 * std::sin(9.0 * f), 0.2 + 0.6 * f } };
    });
  const auto march = alongX<PointKernel<float>, float>(
    table, DefaultAccuracy, 1.0, jitteredLattice(20, 0.15, 1, sineField()));
  EXPECT_GT(march.cells, 40);
  EXPECT_LE(march.lookups, 1.03 * march.cells);
}

// Scalars of cells are constant in them: exact at any level.
TEST(Analytic, CellScalars)
{
  const Grid grid = jitteredLattice(4, 0.0);
  TetMesh mesh = builtWithHierarchy(grid);
  const IntegralTable table = tableOf(
    [](double f) {
      return std::array<double, 4>{ { 1.0, f, 0.0, 0.25 + 0.5 * f } };
    });
  // Layers of cells along x, a quarter thick, of four values.
  std::vector<float> scalars(mesh.Tets.size());
  for (std::size_t t = 0; t < scalars.size(); ++t)
  {
    double x = 0.0;
    for (const Id v : mesh.Tets[t])
    {
      x += 0.25 * (0.5 + double(mesh.Vertices[v].X) * mesh.Frame.Radius);
    }
    scalars[t] = static_cast<float>(std::floor(4.0 * x)) / 3.0f;
  }
  auto kernel = kernelOf<CellKernel<double>, double>(mesh, table, DefaultAccuracy);
  kernel.CellScalars = scalars.data();
  kernel.errorTolerance = 0.0;
  const double thickness = 2.0;
  const auto march =
    kernel.castPlainRay(kernel.rayThrough({ 0.0, 0.013, 0.021 }, { 1.0, 0.0, 0.0 }),
      thickness * mesh.Frame.Radius, -1e30, 1e30);
  double depth = 0.0, green = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const double kappa = 0.25 + 0.5 * i / 3.0;
    const double slab = slabOpacity(kappa * thickness, 0.25);
    green += std::exp(-depth) * slab * i / 3.0;
    depth += kappa * thickness * 0.25;
  }
  EXPECT_NEAR(1.0 - march.radiance.transmittance, -std::expm1(-depth), 4e-7);
  EXPECT_NEAR(march.radiance.color.y, green, 4e-7);
}
} // namespace
