// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march of several components through structured volumes: against the ground truth, closed
// forms and its own bound, with what is random and what is linear.
#include "Reference/ColorAndOpacityConstantKernel.h"
#include "Reference/ColorAndOpacityTrilinearKernel.h"
#include "Reference/DirectColorConstantKernel.h"
#include "Reference/DirectColorTrilinearKernel.h"
#include "Reference/IndependentConstantKernel.h"
#include "Reference/IndependentTrilinearKernel.h"

#include "ClosedForms.h"
#include "StructuredComponentRays.h"

#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;
using Point = tetmarch::testing::Vec3;

constexpr double RoundingOfFloat = 2e-5;

// Uniform in 0..1, another number for each point and component.
std::vector<Field> noise(int components, double factor = 1)
{
  std::vector<Field> fields;
  for (int k = 0; k < components; ++k)
  {
    fields.push_back(
      [k, factor](double x, double y, double z)
      {
        const double s = std::sin(12.9898 * x + 78.233 * y + 37.719 * z + 5 * k) * 43758.5453;
        return factor * (s - std::floor(s));
      });
  }
  return fields;
}

vtkSmartPointer<vtkImageData> noisyImage(int components, int cells = 5)
{
  const auto image = imageOf(constantField(0), unitCube(cells));
  setComponents(image, noise(components), VTK_DOUBLE);
  return image;
}

template <template <typename> class Kernel>
void expectTolerance(int components, bool independent)
{
  const auto image = noisyImage(components);
  StructuredComponentRays rays(image, LatticeValues::PointsLinear, independent);
  for (const double tolerance : { 1.0 / 255, 1.0 / 1024 })
  {
    AccuracyLevel level = levelOf(Accuracy::Default, tolerance);
    level.LeastTableEntries = 16384; // what is between entries is no part of the bound
    level.MostTrials *= 8;           // as Pipeline::levelFor() has it where scalars bend
    ASSERT_NO_FATAL_FAILURE(rays.use(level));
    for (const double unit : { 0.03, 0.2, 1.0 })
    {
      rays.Property->SetScalarOpacityUnitDistance(unit);
      ASSERT_EQ(setFactors(rays.Property, rays.Parts), "");
      const RayErrors found = rays.errorsOf<Kernel<float>, float>(150, 5);
      std::cout << "[ MEASURED ] " << components << " components, tolerance 1/" << 1 / tolerance
                << ", unit " << unit << ": " << found << '\n';
      EXPECT_LE(found.Worst, tolerance + RoundingOfFloat);
      EXPECT_LE(found.OverBound, RoundingOfFloat);
      EXPECT_EQ(found.Lost, 0);
    }
  }
}

// The promise of the bound without any splitting: of rays that it does not help, too.
template <template <typename> class Kernel>
void expectBound(int components, bool independent)
{
  const auto image = noisyImage(components);
  StructuredComponentRays rays(image, LatticeValues::PointsLinear, independent);
  AccuracyLevel level = levelOf(Accuracy::Fast, 1);
  level.LeastTableEntries = level.MostTableEntries = 16384;
  ASSERT_NO_FATAL_FAILURE(rays.use(level));
  for (const double unit : { 0.05, 0.3, 2.0 })
  {
    rays.Property->SetScalarOpacityUnitDistance(unit);
    ASSERT_EQ(setFactors(rays.Property, rays.Parts), "");
    const RayErrors found = rays.errorsOf<Kernel<double>, double>(300, 6);
    std::cout << "[ MEASURED ] taken as it is, " << components << " components, unit " << unit
              << ": " << found << '\n';
    EXPECT_GT(found.Worst, 1e-3);
    EXPECT_LE(found.OverBound, 1e-6);
  }
}

// All that a level of the ground truth leaves, wherever values are.
template <template <typename> class Trilinear, template <typename> class Constant>
void expectTruth(int components, bool independent)
{
  const auto image = noisyImage(components, 4);
  const auto grid = rectilinearOf(constantField(0), unevenCube(4));
  setComponents(grid, noise(components), VTK_DOUBLE);
  for (vtkDataSet* data : { static_cast<vtkDataSet*>(image), static_cast<vtkDataSet*>(grid) })
  {
    for (const LatticeValues values : { LatticeValues::PointsLinear, LatticeValues::CellsLinear,
           LatticeValues::PointsNearest, LatticeValues::CellsNearest })
    {
      SCOPED_TRACE(std::string(data->GetClassName()) + ", values " + std::to_string(int(values)));
      StructuredComponentRays rays(data, values, independent);
      ASSERT_NO_FATAL_FAILURE(rays.use(GroundTruthAccuracy));
      const bool constant = rays.Cells.Constant;
      const RayErrors exact = constant ? rays.errorsOf<Constant<double>, double>(60, 3)
                                       : rays.errorsOf<Trilinear<double>, double>(60, 3);
      EXPECT_LT(exact.Worst, 5e-6);
      EXPECT_EQ(exact.Lost, 0);
      const RayErrors single = constant ? rays.errorsOf<Constant<float>, float>(60, 4)
                                        : rays.errorsOf<Trilinear<float>, float>(60, 4);
      EXPECT_LT(single.Worst, RoundingOfFloat);
      EXPECT_EQ(single.Lost, 0);
    }
  }
}

TEST(StructuredComponentMarch, TwoIndependentOnes)
{
  expectTruth<IndependentTrilinearKernel, IndependentConstantKernel>(2, true);
  expectTolerance<IndependentTrilinearKernel>(2, true);
  expectBound<IndependentTrilinearKernel>(2, true);
}

TEST(StructuredComponentMarch, ThreeIndependentOnes)
{
  expectTruth<IndependentTrilinearKernel, IndependentConstantKernel>(3, true);
  expectTolerance<IndependentTrilinearKernel>(3, true);
}

TEST(StructuredComponentMarch, FourIndependentOnes)
{
  expectTruth<IndependentTrilinearKernel, IndependentConstantKernel>(4, true);
  expectTolerance<IndependentTrilinearKernel>(4, true);
  expectBound<IndependentTrilinearKernel>(4, true);
}

TEST(StructuredComponentMarch, ColorAndOpacity)
{
  expectTruth<ColorAndOpacityTrilinearKernel, ColorAndOpacityConstantKernel>(2, false);
  expectTolerance<ColorAndOpacityTrilinearKernel>(2, false);
  expectBound<ColorAndOpacityTrilinearKernel>(2, false);
}

TEST(StructuredComponentMarch, DirectColor)
{
  expectTruth<DirectColorTrilinearKernel, DirectColorConstantKernel>(4, false);
  expectTolerance<DirectColorTrilinearKernel>(4, false);
  expectBound<DirectColorTrilinearKernel>(4, false);
}

// Bytes are direct colours in 255ths.
TEST(StructuredComponentMarch, ColorsInBytes)
{
  const auto image = imageOf(constantField(0), unitCube(4));
  setComponents(image, noise(4), VTK_UNSIGNED_CHAR);
  StructuredComponentRays rays(image, LatticeValues::PointsLinear, false);
  vtkPiecewiseFunction* opacity = rays.Property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.0, 0.1);
  opacity->AddPoint(90.0, 0.9);
  opacity->AddPoint(255.0, 0.3);
  ASSERT_NO_FATAL_FAILURE(rays.use(GroundTruthAccuracy));
  EXPECT_EQ(rays.Values[1].Type, ValueType::UInt8);
  // The same as reals of 0..1.
  const auto reals = imageOf(constantField(0), unitCube(4));
  setComponents(reals, noise(4), VTK_DOUBLE);
  vtkDataArray* bytes = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < bytes->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      reals->GetPointData()->GetScalars()->SetComponent(
        i, k, bytes->GetComponent(i, k) / (k < 3 ? 255.0 : 1.0));
    }
  }
  StructuredComponentRays others(reals, LatticeValues::PointsLinear, false);
  others.Property->SetScalarOpacity(opacity);
  ASSERT_NO_FATAL_FAILURE(others.use(GroundTruthAccuracy));
  const RayErrors found = rays.errorsOf<DirectColorTrilinearKernel<double>, double>(
    100, 8, [&](const Point& point, const Point& d) { return others.truth(point, d); });
  EXPECT_LT(found.Worst, 5e-6);
}

// The length from a point before the unit cube to where a ray enters it.
double entryOf(const Point& far, const Point& d)
{
  double entry = 0;
  for (int a = 0; a < 3; ++a)
  {
    if (d[a] != 0)
    {
      entry = std::max(entry, ((d[a] > 0 ? 0.0 : 1.0) - far[a]) / d[a]);
    }
  }
  return entry;
}

// The colour of fields that are linear in an even fog.
TEST(StructuredComponentMarch, ClosedFormOfColorsThatAreLinear)
{
  const std::vector<Field> fields = componentFields(4);
  const auto image = imageOf(constantField(0), unitCube(3));
  setComponents(image, fields, VTK_DOUBLE);
  StructuredComponentRays rays(image, LatticeValues::PointsLinear, false);
  vtkNew<vtkPiecewiseFunction> even;
  even->AddPoint(0.0, 0.7);
  rays.Property->SetScalarOpacity(even);
  ASSERT_NO_FATAL_FAILURE(rays.use(GroundTruthAccuracy));
  const double unit = rays.Property->GetScalarOpacityUnitDistance();
  int met = 0;
  const auto expected = [&](const Point& point, const Point& d)
  {
    const Vector3 p = rays.Cells.Frame.toData({ { point[0], point[1], point[2] } });
    const Point far{ p[0] - 9 * d[0], p[1] - 9 * d[1], p[2] - 9 * d[2] };
    const double length = boxChord(far, d, { 0, 0, 0 }, { 1, 1, 1 });
    const double entry = entryOf(far, d);
    Rgba seen{};
    for (int k = 0; k < 3 && length > 1e-9; ++k)
    {
      const auto at = [&](double t)
      { return fields[k](far[0] + t * d[0], far[1] + t * d[1], far[2] + t * d[2]); };
      seen[k] = slabColour(at(entry), at(entry + length), 0.7, length / unit);
    }
    seen[3] = slabOpacity(0.7, length / unit);
    met += length > 1e-9 ? 1 : 0;
    return seen;
  };
  const RayErrors found =
    rays.errorsOf<DirectColorTrilinearKernel<double>, double>(200, 9, expected);
  EXPECT_LT(found.Worst, 5e-6);
  EXPECT_GT(met, 100);
}
} // namespace
