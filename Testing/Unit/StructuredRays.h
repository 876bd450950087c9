// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Rays through a structured volume, marched by a kernel and integrated by the ground truth
 */
#ifndef tetmarch_testing_StructuredRays_h
#define tetmarch_testing_StructuredRays_h

#include "Appearance/TransferTables.h"
#include "Input/GridGeometry.h"
#include "Reference/MakeKernel.h"
#include "Scalars/DrawnScalars.h"
#include "Structured/LatticeBuilder.h"
#include "Structured/StoredValues.h"

#include "ComponentFields.h"
#include "ComponentTruth.h"
#include "CubeChord.h"
#include "LatticeImages.h"
#include "LatticeParts.h"
#include "RayTally.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <random>
#include <type_traits>

namespace tetmarch::testing
{
template <typename Kernel, typename = void>
struct HasComponents : std::false_type
{
};
template <typename Kernel>
struct HasComponents<Kernel, std::void_t<decltype(Kernel::componentCount)>> : std::true_type
{
};

/// A data set with what is drawn of it, and functions.
class StructuredRays
{
public:
  /// A component by the functions, the law and the unit distance of the model.
  StructuredRays(vtkDataSet* data, LatticeValues values, const OpticalModel& model,
    const AccuracyLevel& level = GroundTruthAccuracy)
    : StructuredRays(data, values)
  {
    this->Law = model.Law;
    this->OfOne = std::make_unique<LatticeTruth>(data, model, values);
    this->Property->SetColor(model.Colour);
    this->Property->SetScalarOpacity(model.Opacity);
    this->Property->SetScalarOpacityUnitDistance(model.UnitDistance);
    const double unit = model.UnitDistance / this->Cells.Frame.Radius;
    this->UnitDistances = { unit, unit };
    EXPECT_EQ(this->use(level), "");
  }

  /// Dependent components, unless `independent` is set, by the functions of
  /// setComponentFunctions() and the linear law; before use(). Each ray has its own unit distance.
  StructuredRays(vtkDataSet* data, LatticeValues values, bool independent)
    : StructuredRays(data, values)
  {
    this->Property->SetIndependentComponents(independent);
    setComponentFunctions(this->Property, this->array()->GetNumberOfComponents());
  }

  /// Returns what is wrong.
  std::string use(const AccuracyLevel& level)
  {
    DrawnScalars drawn;
    const std::string error = chooseScalars(this->Data, this->array(), isOfCells(this->Kind),
      { VectorMode::AllComponents, 0 }, this->Property, drawn);
    this->Values = storeValues(drawn);
    TableInput input{ this->Law == testing::OpacityLaw::Linear ? tetmarch::OpacityLaw::Unstructured
                                                               : tetmarch::OpacityLaw::Structured,
      &this->Blend, drawn.Mix, this->Values[0].Range, {}, true };
    for (std::size_t k = 1; k < this->Values.size(); ++k)
    {
      input.ExtraRanges.push_back(this->Values[k].Range);
    }
    this->Parts = {};
    this->Parts.Mix = input.Mix;
    this->Parts.ExtraRanges = input.ExtraRanges;
    this->Table = makeTables(this->Property, input, level, this->Parts);
    this->Level = level;
    this->Truth =
      std::make_unique<ComponentTruth>(this->Data, this->Property, this->Kind, this->Law);
    return error.empty() ? setFactors(this->Property, this->Parts) : error;
  }

  template <typename Kernel>
  Kernel kernel() const
  {
    auto made = makeKernel<Kernel, decltype(Kernel::tableScale)>(
      this->Table, this->Values[0].Range, this->Level);
    made.useLattice(this->Cells, *this->Values.data());
    if constexpr (HasComponents<Kernel>::value)
    {
      made.useComponentTables(this->Parts, this->Values[0].Range);
    }
    return made;
  }

  vtkDataArray* array() const
  {
    return isOfCells(this->Kind) ? this->Data->GetCellData()->GetScalars()
                                 : this->Data->GetPointData()->GetScalars();
  }

  /// A point of the lattice's box, or beyond it, in the normalised frame.
  Vec3 pointNear(std::mt19937& random, double reach) const
  {
    Vec3 p;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = reach * this->Cells.Frame.HalfExtent[k] * (2.0 * uniform(random) - 1.0);
    }
    return p;
  }

  /// A ray of any kind; of three, one begins near the middle of the volume.
  LatticePart nextPart(std::mt19937& random, int i, double reach = 1.1) const
  {
    LatticePart part;
    part.Point = this->pointNear(random, reach);
    part.Direction = randomDirection(random);
    part.Begin = part.offset() + (i % 3 ? -4.0 : 0.1 * uniform(random));
    part.End = part.offset() + 4.0;
    const std::array<double, 2>& units = this->UnitDistances;
    part.UnitDistance =
      units[0] == units[1] ? units[0] : units[0] * std::pow(units[1] / units[0], uniform(random));
    return part;
  }

  /// Calls check(ray, part) with rays of all kinds.
  template <typename Kernel, typename Function>
  void forEachRay(Kernel& kernel, int count, const Function& check) const
  {
    std::mt19937 random(5);
    for (int i = 0; i < count; ++i)
    {
      const LatticePart part = this->nextPart(random, i);
      check(part.of(kernel), part);
    }
  }

  /// What is seen of a ray, up to that depth.
  Rgba truth(const LatticePart& part, double end) const
  {
    const auto [origin, begin, last] = this->inData(part, end);
    if (this->OfOne)
    {
      return this->OfOne->integrate(origin, part.Direction, begin, last);
    }
    // All unit distances, whose ratios are factors of the extinction, change alike.
    const double unit = part.UnitDistance * this->Cells.Frame.Radius;
    const double scale = unit / this->Property->GetScalarOpacityUnitDistance();
    for (int k = 0; k < this->array()->GetNumberOfComponents(); ++k)
    {
      this->Property->SetScalarOpacityUnitDistance(
        k, k == 0 ? unit : scale * this->Property->GetScalarOpacityUnitDistance(k));
    }
    return this->Truth->integrate(origin, part.Direction, begin, last);
  }
  template <typename Ray>
  Rgba truth(const Ray&, const LatticePart& part) const
  {
    return this->truth(part, part.End);
  }

  /// The segments of a ray up to that depth, their ends as depths; of one component.
  std::vector<ScalarSegment> segments(const LatticePart& part, double end) const
  {
    const auto [origin, begin, last] = this->inData(part, end);
    auto segments = this->OfOne->segments(origin, part.Direction, begin, last);
    for (ScalarSegment& segment : segments)
    {
      segment.T0 = segment.T0 / this->Cells.Frame.Radius + part.offset();
      segment.T1 = segment.T1 / this->Cells.Frame.Radius + part.offset();
    }
    return segments;
  }

  /// Of the unit cube.
  template <typename Ray>
  ScalarChord chordOf(const Ray& ray, const Field& field) const
  {
    return cubeChord(this->Cells.Frame.HalfExtent, ray, field);
  }

  /// Thickness of a unit of depth by the model.
  double perDepth() const { return 1 / this->UnitDistances[0]; }

  AccuracyLevel Level = GroundTruthAccuracy;
  vtkNew<vtkVolumeProperty> Property;
  Lattice Cells;
  std::vector<StoredValues> Values;
  Blending Blend;
  Components Parts;
  IntegralTable Table;
  std::array<double, 2> UnitDistances{ { 0.03, 3.0 } }; ///< least and greatest, of the frame

private:
  StructuredRays(vtkDataSet* data, LatticeValues values)
    : Data(data)
    , Kind(values)
  {
    GridGeometry geometry;
    EXPECT_EQ(readGeometry(data, geometry), "");
    VolumeFrame frame;
    EXPECT_EQ(findFrame(geometry, frame), "");
    const Interpolation between = isLinear(values) ? Interpolation::Linear : Interpolation::Nearest;
    EXPECT_EQ(makeLattice(geometry, frame, { isOfCells(values), between }, this->Cells), "");
  }

  struct DataPart
  {
    Vec3 Origin;
    double Begin;
    double End;
  };
  DataPart inData(const LatticePart& part, double end) const
  {
    const Vector3 origin =
      this->Cells.Frame.toData({ { part.Point[0], part.Point[1], part.Point[2] } });
    const double r = this->Cells.Frame.Radius;
    return { { origin[0], origin[1], origin[2] }, (part.Begin - part.offset()) * r,
      (end - part.offset()) * r };
  }

  vtkSmartPointer<vtkDataSet> Data;
  testing::OpacityLaw Law = testing::OpacityLaw::Linear;
  LatticeValues Kind;
  std::unique_ptr<LatticeTruth> OfOne; // with functions of a model, whose unit distance is fixed
  std::unique_ptr<ComponentTruth> Truth;
};
} // namespace tetmarch::testing

#endif
