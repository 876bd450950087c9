// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Rays through a structured volume with several components, marched by a kernel and
 * integrated by the ground truth
 */
#ifndef tetmarch_testing_StructuredComponentRays_h
#define tetmarch_testing_StructuredComponentRays_h

#include "Appearance/Components.h"

#include "ComponentFields.h"
#include "ComponentTruth.h"
#include "StructuredRays.h"

#include <algorithm>
#include <ostream>

namespace tetmarch::testing
{
/// How far rays are off, and whether their bounds hold.
struct RayErrors
{
  double Worst = 0;     // of a channel
  double OverBound = 0; // error less its bound
  double Bound = 0;     // sum
  double Error = 0;     // sum
  long Rays = 0;
  long Lost = 0;
  long Lookups = 0;
};

inline std::ostream& operator<<(std::ostream& out, const RayErrors& errors)
{
  return out << "worst " << errors.Worst << ", bound " << errors.Bound / errors.Error
             << " times the error, " << double(errors.Lookups) / double(errors.Rays)
             << " lookups a ray, " << errors.Rays << " rays";
}

class StructuredComponentRays
{
public:
  /// Dependent components, unless `independent` is set, with the functions of
  /// setComponentFunctions(), by the linear law.
  StructuredComponentRays(vtkDataSet* data, LatticeValues values, bool independent)
    : Data(data)
    , OfCells(values == LatticeValues::CellsLinear || values == LatticeValues::CellsNearest)
    , Kind(values)
  {
    const bool linear =
      values == LatticeValues::PointsLinear || values == LatticeValues::CellsLinear;
    this->Property->SetIndependentComponents(independent);
    setComponentFunctions(this->Property, this->array()->GetNumberOfComponents());
    GridGeometry geometry;
    EXPECT_EQ(readGeometry(data, geometry), "");
    VolumeFrame frame;
    EXPECT_EQ(findFrame(geometry, frame), "");
    EXPECT_EQ(
      makeLattice(geometry, frame,
        { this->OfCells, linear ? Interpolation::Linear : Interpolation::Nearest }, this->Cells),
      "");
  }

  vtkDataArray* array() const
  {
    return this->OfCells ? this->Data->GetCellData()->GetScalars()
                         : this->Data->GetPointData()->GetScalars();
  }

  void use(const AccuracyLevel& level)
  {
    DrawnScalars drawn;
    ASSERT_EQ(chooseScalars(this->Data, this->array(), this->OfCells,
                { VectorMode::AllComponents, 0 }, this->Property, drawn),
      "");
    this->Values = storeValues(drawn);
    this->Parts = {};
    this->Parts.Mix = drawn.Mix;
    for (std::size_t k = 1; k < this->Values.size(); ++k)
    {
      this->Parts.FurtherRanges.push_back(this->Values[k].Range);
    }
    this->Table = componentTables(this->Property, tetmarch::OpacityLaw::Unstructured,
      this->Values[0].Range, level, this->Parts);
    ASSERT_EQ(setFactors(this->Property, this->Parts), "");
    this->Level = level;
    this->Truth.reset(
      new ComponentTruth(this->Data, this->Property, this->Kind, testing::OpacityLaw::Linear));
  }

  template <typename Kernel, typename Real>
  Kernel kernel() const
  {
    auto made = makeKernel<Kernel, Real>(this->Table, this->Values[0].Range, this->Level);
    made.useLattice(this->Cells, *this->Values.data());
    made.useComponentTables(this->Parts, this->Values[0].Range);
    made.mostTrials = this->Level.Adaptive ? this->Level.MostTrials : 0;
    return made;
  }

  /// Thickness of a unit of depth.
  double perDepth() const
  {
    return this->Cells.Frame.Radius / this->Property->GetScalarOpacityUnitDistance();
  }

  /// What a ray of the normalised frame sees, front to back.
  template <typename Kernel, typename Real>
  Rgba cast(
    Kernel& kernel, const Vec3& point, const Vec3& d, RayErrors& errors, double& bound) const
  {
    const auto ray = kernel.rayThrough(
      { Real(point[0]), Real(point[1]), Real(point[2]) }, { Real(d[0]), Real(d[1]), Real(d[2]) });
    const double offset = point[0] * d[0] + point[1] * d[1] + point[2] * d[2];
    const auto march =
      kernel.castPlainRay(ray, Real(this->perDepth()), Real(offset - 4), Real(offset + 4));
    errors.Lost += march.lost + march.guarded;
    errors.Lookups += march.lookups;
    ++errors.Rays;
    bound = double(kernel.errorBound(march.radiance));
    const auto color = kernel.pixelOf(march.radiance, Real(1));
    return { { double(color.x), double(color.y), double(color.z), double(color.w) } };
  }

  Rgba truth(const Vec3& point, const Vec3& direction) const
  {
    const Vector3 origin = this->Cells.Frame.toData({ { point[0], point[1], point[2] } });
    const double r = this->Cells.Frame.Radius;
    return this->Truth->integrate(
      { origin[0], origin[1], origin[2] }, direction, -4.0 * r, 4.0 * r);
  }

  Vec3 pointNear(std::mt19937& random) const
  {
    Vec3 p;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = 1.1 * this->Cells.Frame.HalfExtent[k] * (2.0 * StructuredRays::share(random) - 1.0);
    }
    return p;
  }

  /// Of rays of all kinds, against the ground truth or what `expected` says of a ray.
  template <typename Kernel, typename Real, typename Expected>
  RayErrors errorsOf(int count, unsigned seed, const Expected& expected) const
  {
    auto kernel = this->kernel<Kernel, Real>();
    std::mt19937 random(seed);
    RayErrors errors;
    for (int i = 0; i < count; ++i)
    {
      const Vec3 point = this->pointNear(random);
      const Vec3 d = StructuredRays::direction(random);
      double bound = 0;
      const Rgba found = this->cast<Kernel, Real>(kernel, point, d, errors, bound);
      const Rgba wanted = expected(point, d);
      double error = 0;
      for (int k = 0; k < 4; ++k)
      {
        EXPECT_TRUE(std::isfinite(found[k]));
        error = std::max(error, std::abs(found[k] - wanted[k]));
      }
      errors.Worst = std::max(errors.Worst, error);
      errors.OverBound = std::max(errors.OverBound, error - bound);
      errors.Bound += bound;
      errors.Error += error;
    }
    return errors;
  }

  template <typename Kernel, typename Real>
  RayErrors errorsOf(int count, unsigned seed) const
  {
    return this->errorsOf<Kernel, Real>(
      count, seed, [this](const Vec3& point, const Vec3& d) { return this->truth(point, d); });
  }

  vtkDataSet* Data;
  bool OfCells;
  LatticeValues Kind;
  vtkNew<vtkVolumeProperty> Property;
  Lattice Cells;
  std::vector<StoredValues> Values;
  Components Parts;
  IntegralTable Table;
  AccuracyLevel Level = GroundTruthAccuracy;
  std::unique_ptr<ComponentTruth> Truth;
};
} // namespace tetmarch::testing

#endif
