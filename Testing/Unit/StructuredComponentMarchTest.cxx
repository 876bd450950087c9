// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march of several components through structured volumes, against the ground truth and closed
// forms.
#include "Reference/ColorAndOpacityConstantKernel.h"
#include "Reference/ColorAndOpacityTrilinearKernel.h"
#include "Reference/DirectColorConstantKernel.h"
#include "Reference/DirectColorTrilinearKernel.h"
#include "Reference/IndependentConstantKernel.h"
#include "Reference/IndependentTrilinearKernel.h"

#include "MarchKinds.h"
#include "StructuredRays.h"

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

std::vector<Field> roughFields(int components)
{
  std::vector<Field> fields;
  for (int k = 0; k < components; ++k)
  {
    fields.push_back(scatteredField(5 * k));
  }
  return fields;
}

vtkSmartPointer<vtkImageData> imageOf(const std::vector<Field>& fields, int cells, int type)
{
  const auto image = imageOf(constantField(0), unitCube(cells));
  setComponents(image, fields, type);
  return image;
}

struct Lattices
{
  static constexpr bool IsLit = false;
  static constexpr double TruthError = 1e-6;
  static constexpr int RaysOfAPlace = 60;
  static constexpr int TrialFactor = 8;

  template <typename Function>
  static void forEach(int components, bool independent, const Function& call)
  {
    const auto image = imageOf(roughFields(components), 5, VTK_DOUBLE);
    StructuredRays rays(image, LatticeValues::PointsLinear, independent);
    call(rays);
  }

  template <typename Function>
  static void forEachPlace(int components, bool independent, const Function& call)
  {
    const auto image = imageOf(roughFields(components), 4, VTK_DOUBLE);
    const auto grid = rectilinearOf(constantField(0), unevenCube(4));
    setComponents(grid, roughFields(components), VTK_DOUBLE);
    for (vtkDataSet* data : { static_cast<vtkDataSet*>(image), static_cast<vtkDataSet*>(grid) })
    {
      for (const LatticeValues values : AllLatticeValues)
      {
        SCOPED_TRACE(std::string(data->GetClassName()) + ", values " + std::to_string(int(values)));
        StructuredRays rays(data, values, independent);
        rays.UnitDistances = { 0.2, 3.0 }; // the thicker, the more is lost in float
        call(rays, rays.Cells.Constant);
      }
    }
  }
};

template <int Components>
using IndependentLattice = MarchKind<Lattices, Components, true, IndependentTrilinearKernel,
  IndependentTrilinearKernel, IndependentConstantKernel>;

using LatticeKinds =
  ::testing::Types<IndependentLattice<2>, IndependentLattice<3>, IndependentLattice<4>,
    MarchKind<Lattices, 2, false, ColorAndOpacityTrilinearKernel, ColorAndOpacityTrilinearKernel,
      ColorAndOpacityConstantKernel>,
    MarchKind<Lattices, 4, false, DirectColorTrilinearKernel, DirectColorTrilinearKernel,
      DirectColorConstantKernel>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Lattices, MarchOf, LatticeKinds, KindNames);

// Bytes are direct colours in 255ths.
TEST(StructuredComponentMarch, ColorsInBytes)
{
  const auto image = imageOf(roughFields(4), 4, VTK_UNSIGNED_CHAR);
  StructuredRays rays(image, LatticeValues::PointsLinear, false);
  vtkPiecewiseFunction* opacity = rays.Property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.0, 0.1);
  opacity->AddPoint(90.0, 0.9);
  opacity->AddPoint(255.0, 0.3);
  ASSERT_EQ(rays.use(GroundTruthAccuracy), "");
  EXPECT_EQ(rays.Values[1].Type, ValueType::UInt8);
  // The same as reals of 0..1.
  const auto reals = imageOf(roughFields(4), 4, VTK_DOUBLE);
  vtkDataArray* bytes = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < bytes->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      reals->GetPointData()->GetScalars()->SetComponent(
        i, k, bytes->GetComponent(i, k) / (k < 3 ? 255.0 : 1.0));
    }
  }
  StructuredRays others(reals, LatticeValues::PointsLinear, false);
  others.Property->SetScalarOpacity(opacity);
  ASSERT_EQ(others.use(GroundTruthAccuracy), "");
  RayTally tally;
  tallyRays(tally, rays, rays.kernel<DirectColorTrilinearKernel<double>>(), 100,
    [&](const auto& ray, const auto& part) { return others.truth(ray, part); });
  EXPECT_LT(tally.Worst, 5e-6);
}

TEST(StructuredComponentMarch, ColorsThatAreLinearInAnEvenFog)
{
  const auto image = imageOf(componentFields(4), 3, VTK_DOUBLE);
  StructuredRays rays(image, LatticeValues::PointsLinear, false);
  expectLinearColors<DirectColorTrilinearKernel<double>>(rays);
}
} // namespace
