// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Rays through a structured volume, marched by a kernel and integrated by the ground truth
 */
#ifndef tetmarch_testing_StructuredRays_h
#define tetmarch_testing_StructuredRays_h

#include "Appearance/Blending.h"
#include "Input/GridGeometry.h"
#include "Reference/MakeKernel.h"
#include "Scalars/DrawnScalars.h"
#include "Structured/LatticeBuilder.h"
#include "Structured/StoredValues.h"

#include "LatticeImages.h"
#include "LatticeTruth.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace tetmarch::testing
{
using Rgba = std::array<double, 4>;

/// A data set with what is drawn of it, and functions.
class StructuredRays
{
public:
  StructuredRays(vtkDataSet* data, LatticeValues values, const OpticalModel& model,
    const AccuracyLevel& level = GroundTruthAccuracy)
    : Level(level)
    , Truth(data, model, values)
  {
    const bool ofCells =
      values == LatticeValues::CellsLinear || values == LatticeValues::CellsNearest;
    const bool linear =
      values == LatticeValues::PointsLinear || values == LatticeValues::CellsLinear;
    GridGeometry geometry;
    EXPECT_EQ(readGeometry(data, geometry), "");
    VolumeFrame frame;
    EXPECT_EQ(findFrame(geometry, frame), "");
    EXPECT_EQ(makeLattice(geometry, frame,
                { ofCells, linear ? Interpolation::Linear : Interpolation::Nearest }, this->Cells),
      "");
    DrawnScalars drawn;
    drawn.Array = ofCells ? data->GetCellData()->GetScalars() : data->GetPointData()->GetScalars();
    drawn.OfCells = ofCells;
    this->Values = storeValues(drawn);
    vtkNew<vtkVolumeProperty> property;
    property->SetColor(model.Colour);
    property->SetScalarOpacity(model.Opacity);
    this->Table = blendedTable(property,
      model.Law == testing::OpacityLaw::Linear ? tetmarch::OpacityLaw::Unstructured
                                               : tetmarch::OpacityLaw::Structured,
      this->Blend, this->Values[0].Range, level);
    addExtinctionVariations(this->Table);
    addSlopeVariations(this->Table);
    this->PerDepth = frame.Radius / model.UnitDistance;
  }

  template <typename Kernel, typename Real>
  Kernel kernel() const
  {
    auto made = makeKernel<Kernel, Real>(this->Table, this->Values[0].Range, this->Level);
    made.useLattice(this->Cells, this->Values[0]);
    return made;
  }

  /// A point of the lattice's box, or beyond it, in the normalised frame.
  Vec3 pointNear(std::mt19937& random, double reach) const
  {
    Vec3 p;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = reach * this->Cells.Frame.HalfExtent[k] * (2.0 * share(random) - 1.0);
    }
    return p;
  }

  static double share(std::mt19937& random) { return double(random()) / 4294967296.0; }

  /// Of generic directions every second one; the others are along axes or in planes of cells.
  static Vec3 direction(std::mt19937& random)
  {
    Vec3 d{ 0.0, 0.0, 0.0 };
    const unsigned kind = random() % 4;
    for (int k = 0; k < 3; ++k)
    {
      d[k] = kind < 2    ? 2.0 * share(random) - 1.0
             : kind == 2 ? double(random() % 3) - 1.0
                         : (random() % 2 ? 2.0 * share(random) - 1.0 : 0.0);
    }
    const double length = std::hypot(d[0], d[1], d[2]);
    return length < 1e-3 ? Vec3{ 0.0, 0.0, 1.0 }
                         : Vec3{ d[0] / length, d[1] / length, d[2] / length };
  }

  /// The ground truth of a ray of the normalised frame.
  Rgba truth(const Vec3& point, const Vec3& direction, double begin, double end) const
  {
    const Vector3 origin = this->Cells.Frame.toData({ { point[0], point[1], point[2] } });
    const double r = this->Cells.Frame.Radius;
    return this->Truth.integrate(
      { origin[0], origin[1], origin[2] }, direction, begin * r, end * r);
  }

  AccuracyLevel Level;
  LatticeTruth Truth;
  Lattice Cells;
  std::vector<StoredValues> Values;
  Blending Blend;
  IntegralTable Table;
  double PerDepth = 1; ///< thickness of a unit of depth
};

/// Red rises, blue has a peak; the opacity is a ramp with a narrow peak.
inline OpticalModel rampAndPeak(double unitDistance)
{
  OpticalModel model;
  model.Colour = vtkSmartPointer<vtkColorTransferFunction>::New();
  model.Colour->AddRGBPoint(0.0, 0.1, 0.9, 0.0);
  model.Colour->AddRGBPoint(0.45, 0.2, 0.3, 0.1);
  model.Colour->AddRGBPoint(0.5, 0.9, 0.1, 0.9);
  model.Colour->AddRGBPoint(1.0, 1.0, 0.2, 0.3);
  model.Opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
  model.Opacity->AddPoint(0.0, 0.0);
  model.Opacity->AddPoint(0.4, 0.2);
  model.Opacity->AddPoint(0.48, 0.1);
  model.Opacity->AddPoint(0.5, 0.9);
  model.Opacity->AddPoint(0.52, 0.1);
  model.Opacity->AddPoint(1.0, 0.6);
  model.UnitDistance = unitDistance;
  return model;
}
} // namespace tetmarch::testing

#endif
