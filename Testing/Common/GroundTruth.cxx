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
namespace
{
std::array<double, 4> rgbaOf(const SegmentResult& all)
{
  return { all.Colour[0], all.Colour[1], all.Colour[2], -std::expm1(-all.Depth) };
}
} // namespace

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
  return rgbaOf(this->march({ origin, direction }, tMin, tMax,
    [this](double f0, double f1, const Chord& chord)
    { return this->Optics.integrate(f0, f1, chord.T1 - chord.T0); }));
}

std::array<double, 4> GroundTruthScene::integrateLit(const Vec3& origin, const Vec3& direction,
  const std::function<double(const Vec3&)>& brightness, double tolerance) const
{
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  const auto segment = [&](double f0, double f1, const Chord& chord)
  {
    const auto at = [&](double share)
    {
      const double t = (chord.T0 + share * (chord.T1 - chord.T0)) / length;
      return brightness({ origin[0] + t * direction[0], origin[1] + t * direction[1],
        origin[2] + t * direction[2] });
    };
    return this->Optics.integrateLit(Cubic::linear(f0, f1), chord.T1 - chord.T0, at, tolerance);
  };
  return rgbaOf(this->march({ origin, direction }, 0.0, Infinity, segment));
}

double GroundTruthScene::depth(
  const Vec3& origin, const Vec3& direction, double tMin, double tMax) const
{
  return this
    ->march({ origin, direction }, tMin, tMax,
      [this](double f0, double f1, const Chord& chord)
      { return this->Optics.integrate(f0, f1, chord.T1 - chord.T0); })
    .Depth;
}

template <typename Segment>
SegmentResult GroundTruthScene::march(
  const Ray& ray, double tMin, double tMax, const Segment& segment) const
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
      all = composed(all, segment(f0, f1, chord));
    }
  }
  return all;
}
} // namespace tetmarch::testing
