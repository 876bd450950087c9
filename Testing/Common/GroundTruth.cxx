// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GroundTruth.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <stdexcept>

namespace tetmarch::testing
{
GroundTruthScene::GroundTruthScene(
  vtkUnstructuredGrid* grid, const OpticalModel& model, ScalarsOf scalars)
  : Chords(grid)
  , Optics(model)
  , Kind(scalars)
{
  vtkDataArray* values = scalars == ScalarsOf::Points ? grid->GetPointData()->GetScalars()
                                                      : grid->GetCellData()->GetScalars();
  if (!values)
  {
    throw std::invalid_argument("GroundTruthScene needs active scalars");
  }
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    this->Scalars.push_back(values->GetComponent(i, 0));
  }
}

double GroundTruthScene::pathLength(
  const Vec3& origin, const Vec3& direction, double tMin, double tMax) const
{
  double length = 0.0;
  for (const Chord& chord :
    RayChords::withoutOverlap(this->Chords.find({ origin, direction }, tMin, tMax)))
  {
    length += chord.T1 - chord.T0;
  }
  return length;
}

std::array<double, 4> GroundTruthScene::integrate(
  const Vec3& origin, const Vec3& direction, double tMin, double tMax) const
{
  const SegmentResult all = this->march({ origin, direction }, tMin, tMax);
  return { all.Colour[0], all.Colour[1], all.Colour[2], -std::expm1(-all.Depth) };
}

double GroundTruthScene::depth(
  const Vec3& origin, const Vec3& direction, double tMin, double tMax) const
{
  return this->march({ origin, direction }, tMin, tMax).Depth;
}

SegmentResult GroundTruthScene::march(const Ray& ray, double tMin, double tMax) const
{
  SegmentResult all;
  for (const Chord& chord : RayChords::withoutOverlap(this->Chords.find(ray, tMin, tMax)))
  {
    double f0 = 0.0;
    double f1 = 0.0;
    if (this->Kind == ScalarsOf::Cells)
    {
      f0 = f1 = this->Scalars[chord.Cell];
    }
    else
    {
      for (int i = 0; i < 4; ++i)
      {
        const double f = this->Scalars[this->Chords.pointOf(chord.Cell, i)];
        f0 += chord.W0[i] * f;
        f1 += chord.W1[i] * f;
      }
    }
    if (std::isfinite(f0) && std::isfinite(f1))
    {
      all = composed(all, this->Optics.integrate(f0, f1, chord.T1 - chord.T0));
    }
  }
  return all;
}
} // namespace tetmarch::testing
