// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tetrahedra as a volume of MarchKinds.h, in light and without; and their cells
 */
#ifndef tetmarch_testing_TetKinds_h
#define tetmarch_testing_TetKinds_h

#include "LitComponentRays.h"
#include "MarchKinds.h"

namespace tetmarch::testing
{
/// Of ComponentRays or LitComponentRays.
template <typename RaysOf>
struct Tetrahedra
{
  using Rays = RaysOf;
  static constexpr bool IsLit = std::is_same_v<Rays, LitComponentRays>;
  static constexpr double TruthError = Rounding; // a quadrature in steps
  static constexpr int RaysOfAPlace = 400;
  static constexpr int TrialFactor = 1;

  template <typename Function>
  static void forEach(int components, bool independent, const Function& call)
  {
    for (const int cubes : { 1, 2, 5 })
    {
      Rays rays(jitteredLattice(cubes, 0.15), components, independent);
      call(rays);
    }
  }

  template <typename Function>
  static void forEachPlace(int components, bool independent, const Function& call)
  {
    for (const int cubes : { 1, 5 })
    {
      Rays rays(jitteredLattice(cubes, 0.15), components, independent);
      call(rays, false);
    }
  }
};

template <typename Kind>
class CellsOf : public ::testing::Test
{
};
TYPED_TEST_SUITE_P(CellsOf);

// Cells of constant scalars are exact: a ray through one of two cells alone has its colour.
TYPED_TEST_P(CellsOf, HaveTheirColor)
{
  using Kernel = typename TypeParam::template Constant<double>;
  typename TypeParam::Volume::Rays rays(
    twoTetsSharingFace(), TypeParam::Components, TypeParam::Independent, true);
  ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
  Kernel kernel = rays.template kernel<Kernel>();
  RandomRays random(3);
  int checked = 0;
  for (int i = 0; i < 200; ++i)
  {
    const auto ray = random.next<Kernel, double>(kernel, rays.Rays.Mesh);
    // A unit of depth is three scalar opacity unit distances.
    const auto march = kernel.castPlainRay(ray, 3.0, -3.0, 3.0);
    const auto color = kernel.pixelOf(march.radiance, 3.0);
    const auto isOfCell = [&](int cell)
    {
      std::vector<double> tuple(rays.Fields.size());
      rays.Data->GetCellData()->GetScalars()->GetTuple(cell, tuple.data());
      const Rgba medium = mediumAt(rays.Property, tuple); // C tau, tau
      const double scale = color.w / medium[3];
      const Rgba expected = rays.inLight(
        ray, Rgba{ { medium[0] * scale, medium[1] * scale, medium[2] * scale, color.w } });
      return std::abs(color.x - expected[0]) < 1e-4 && std::abs(color.y - expected[1]) < 1e-4 &&
             std::abs(color.z - expected[2]) < 1e-4;
    };
    if (march.cells == 1 && color.w > 1e-2)
    {
      EXPECT_TRUE(isOfCell(0) || isOfCell(1));
      ++checked;
    }
  }
  EXPECT_GT(checked, 20);
}

REGISTER_TYPED_TEST_SUITE_P(CellsOf, HaveTheirColor);
} // namespace tetmarch::testing

#endif
