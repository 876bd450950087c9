// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LatticeTruth.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tetmarch::testing
{
namespace
{
// Tuples whose ghost value has one of the bits; none without such an array.
std::vector<bool> markedBy(vtkDataSetAttributes* attributes, vtkIdType count, int bits)
{
  std::vector<bool> marked(count, false);
  vtkDataArray* ghosts = attributes->GetArray(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; ghosts && i < count; ++i)
  {
    marked[i] = (static_cast<int>(ghosts->GetComponent(i, 0)) & bits) != 0;
  }
  return marked;
}

long double between(long double a, long double b, long double t) { return a + t * (b - a); }
} // namespace

LatticeTruth::LatticeTruth(
  vtkDataSet* data, const OpticalModel& model, LatticeValues values, int component)
  : Chords(data, values)
  , Optics(model)
  , Model(model)
  , Kind(values)
{
  this->readScalars(data, !isOfCells(values), component);
  this->readHidden(data);
}

void LatticeTruth::readScalars(vtkDataSet* data, bool ofPoints, int component)
{
  vtkDataArray* array =
    ofPoints ? data->GetPointData()->GetScalars() : data->GetCellData()->GetScalars();
  if (!array || component >= array->GetNumberOfComponents())
  {
    throw std::invalid_argument("LatticeTruth needs active scalars with that component");
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    this->Scalars.push_back(array->GetComponent(i, component));
  }
}

template <typename Found>
void LatticeTruth::forCellsAround(vtkIdType point, const Found& found) const
{
  const vtkIdType nx = this->Chords.cells(0);
  const vtkIdType ny = this->Chords.cells(1);
  const vtkIdType at[3] = { point % (nx + 1), point / (nx + 1) % (ny + 1),
    point / (nx + 1) / (ny + 1) };
  for (int corner = 0; corner < 8; ++corner)
  {
    vtkIdType cell[3];
    bool exists = true;
    for (int a = 0; a < 3; ++a)
    {
      cell[a] = at[a] - (corner >> a & 1);
      exists = exists && cell[a] >= 0 && cell[a] < this->Chords.cells(a);
    }
    if (exists)
    {
      found(cell[0] + nx * (cell[1] + ny * cell[2]));
    }
  }
}

void LatticeTruth::readHidden(vtkDataSet* data)
{
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const std::vector<bool> marked = markedBy(data->GetCellData(), data->GetNumberOfCells(),
    vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL |
      vtkDataSetAttributes::REFINEDCELL);
  const std::vector<bool> points =
    markedBy(data->GetPointData(), data->GetNumberOfPoints(), vtkDataSetAttributes::HIDDENPOINT);
  this->HiddenCells = marked;
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    bool alone = true;
    this->forCellsAround(p,
      [&](vtkIdType cell)
      {
        alone = alone && marked[cell];
        this->HiddenCells[cell] = this->HiddenCells[cell] || points[p];
      });
    if (this->Kind == LatticeValues::PointsNearest && (points[p] || alone))
    {
      this->Scalars[p] = nothing;
    }
  }
  for (vtkIdType cell = 0; isOfCells(this->Kind) && cell < data->GetNumberOfCells(); ++cell)
  {
    this->Scalars[cell] = this->HiddenCells[cell] ? nothing : this->Scalars[cell];
  }
}

// Nothing if the box is not drawn.
std::optional<Cubic> LatticeTruth::scalarAlong(const LatticeChord& chord) const
{
  const LatticeSlab* slabs[3];
  for (int a = 0; a < 3; ++a)
  {
    slabs[a] = &this->Chords.slab(a, chord.Slabs[a]);
  }
  const auto cell =
    slabs[0]->Cell +
    static_cast<std::size_t>(this->Chords.cells(0)) *
      (slabs[1]->Cell + static_cast<std::size_t>(this->Chords.cells(1)) * slabs[2]->Cell);
  if (this->Kind == LatticeValues::PointsLinear && this->HiddenCells[cell])
  {
    return {};
  }
  double corners[2][2][2]; // k, j, i
  for (int c = 0; c < 8; ++c)
  {
    const int i = c & 1;
    const int j = c >> 1 & 1;
    const int k = c >> 2;
    const auto value = slabs[0]->Values[i] +
                       static_cast<std::size_t>(this->Chords.count(0)) *
                         (slabs[1]->Values[j] +
                           static_cast<std::size_t>(this->Chords.count(1)) * slabs[2]->Values[k]);
    corners[k][j][i] = this->Scalars[value];
    if (!std::isfinite(corners[k][j][i]))
    {
      return {};
    }
  }
  std::array<long double, 4> values;
  for (int n = 0; n < 4; ++n)
  {
    long double at[3];
    for (int a = 0; a < 3; ++a)
    {
      at[a] = between(chord.Begin[a], chord.End[a], n / 3.0L);
    }
    long double layers[2];
    for (int k = 0; k < 2; ++k)
    {
      layers[k] = between(between(corners[k][0][0], corners[k][0][1], at[0]),
        between(corners[k][1][0], corners[k][1][1], at[0]), at[1]);
    }
    values[n] = between(layers[0], layers[1], at[2]);
  }
  return Cubic::through(values);
}

std::vector<ScalarSegment> LatticeTruth::segments(
  const Vec3& origin, const Vec3& direction, double tMin, double tMax) const
{
  std::vector<ScalarSegment> segments;
  for (const LatticeChord& chord : this->Chords.find({ origin, direction }, tMin, tMax))
  {
    if (const std::optional<Cubic> scalar = this->scalarAlong(chord))
    {
      segments.push_back({ chord.T0, chord.T1, *scalar });
    }
  }
  return segments;
}

double LatticeTruth::pathLength(
  const Vec3& origin, const Vec3& direction, double tMin, double tMax) const
{
  double length = 0.0;
  for (const ScalarSegment& segment : this->segments(origin, direction, tMin, tMax))
  {
    length += segment.T1 - segment.T0;
  }
  return length;
}

SegmentResult LatticeTruth::march(const Ray& ray, double tMin, double tMax) const
{
  SegmentResult all;
  for (const ScalarSegment& segment : this->segments(ray.Origin, ray.Direction, tMin, tMax))
  {
    all = composed(all, this->Optics.integrate(segment.Scalar, segment.T1 - segment.T0));
  }
  return all;
}

std::array<double, 4> LatticeTruth::integrate(
  const Vec3& origin, const Vec3& direction, double tMin, double tMax) const
{
  const SegmentResult all = this->march({ origin, direction }, tMin, tMax);
  return { all.Colour[0], all.Colour[1], all.Colour[2], -std::expm1(-all.Depth) };
}

std::array<double, 4> LatticeTruth::integrateLit(const Vec3& origin, const Vec3& direction,
  const std::function<double(const Vec3&)>& brightness, double tolerance) const
{
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  SegmentResult all;
  for (const ScalarSegment& segment : this->segments(origin, direction))
  {
    const auto at = [&](double share)
    {
      const double t = (segment.T0 + share * (segment.T1 - segment.T0)) / length;
      return brightness({ origin[0] + t * direction[0], origin[1] + t * direction[1],
        origin[2] + t * direction[2] });
    };
    all = composed(
      all, this->Optics.integrateLit(segment.Scalar, segment.T1 - segment.T0, at, tolerance));
  }
  return { all.Colour[0], all.Colour[1], all.Colour[2], -std::expm1(-all.Depth) };
}

double LatticeTruth::depth(
  const Vec3& origin, const Vec3& direction, double tMin, double tMax) const
{
  return this->march({ origin, direction }, tMin, tMax).Depth;
}

std::optional<std::array<double, 2>> LatticeTruth::extremes(
  const Vec3& origin, const Vec3& direction, double tMin, double tMax) const
{
  std::optional<std::array<double, 2>> found;
  for (const ScalarSegment& segment : this->segments(origin, direction, tMin, tMax))
  {
    const double least = segment.Scalar.least();
    const double greatest = segment.Scalar.greatest();
    found =
      found ? std::array<double, 2>{ std::min((*found)[0], least), std::max((*found)[1], greatest) }
            : std::array<double, 2>{ least, greatest };
  }
  return found;
}

OpacitySums LatticeTruth::opacitySums(const Vec3& origin, const Vec3& direction, double low,
  double high, double tMin, double tMax) const
{
  OpacitySums sums;
  for (const ScalarSegment& segment : this->segments(origin, direction, tMin, tMax))
  {
    sums =
      composed(sums, this->Optics.opacitySums(segment.Scalar, segment.T1 - segment.T0, low, high));
  }
  return sums;
}

std::vector<SurfaceCrossing> LatticeTruth::crossings(const Vec3& origin, const Vec3& direction,
  const std::vector<double>& values, double tMin, double tMax) const
{
  const bool isContinuous = isLinear(this->Kind);
  std::vector<SurfaceCrossing> found;
  const std::vector<ScalarSegment> segments = this->segments(origin, direction, tMin, tMax);
  for (const double value : values)
  {
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      const ScalarSegment& segment = segments[i];
      // In the face between two cells rounding may have it reached on one side alone.
      if (i > 0 && isContinuous && segments[i - 1].T1 == segment.T0 &&
          (segments[i - 1].Scalar.at(1.0) < value) != (segment.Scalar.at(0.0) < value))
      {
        found.push_back({ segment.T0, value });
      }
      for (const double u : segment.Scalar.crossingsOf(value))
      {
        found.push_back({ segment.T0 + u * (segment.T1 - segment.T0), value });
      }
    }
  }
  std::stable_sort(found.begin(), found.end(),
    [](const SurfaceCrossing& a, const SurfaceCrossing& b) { return a.T < b.T; });
  return found;
}

std::array<double, 4> LatticeTruth::isosurfaces(const Vec3& origin, const Vec3& direction,
  const std::vector<double>& values, double tMin, double tMax) const
{
  std::array<double, 4> seen{};
  for (const SurfaceCrossing& crossing : this->crossings(origin, direction, values, tMin, tMax))
  {
    const Vec3 colour = this->Model.colour(crossing.Value);
    const double alpha = (1.0 - seen[3]) * this->Model.Opacity->GetValue(crossing.Value);
    for (int c = 0; c < 3; ++c)
    {
      seen[c] += alpha * colour[c];
    }
    seen[3] += alpha;
  }
  return seen;
}
} // namespace tetmarch::testing
