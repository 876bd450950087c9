// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LatticeChords.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace tetmarch::testing
{
namespace
{
using Vec3l = std::array<long double, 3>;

Vec3l cross(const Vec3l& a, const Vec3l& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

long double dot(const Vec3l& a, const Vec3l& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The slabs of cell c between two points of an axis; where cells have a value, that is at the
// middle of the cell, and there is one before and behind it or not.
void addSlabs(const std::vector<double>& points, int c, LatticeValues values,
  const std::function<void(double, double, int, int, double, double)>& add)
{
  const auto centre = [&](int cell) { return 0.5 * (points[cell] + points[cell + 1]); };
  const double a = points[c];
  const double b = points[c + 1];
  const int last = static_cast<int>(points.size()) - 2;
  switch (values)
  {
    case LatticeValues::PointsLinear:
      add(a, b, c, c + 1, a, b);
      break;
    case LatticeValues::PointsNearest:
      add(a, centre(c), c, c, a, b);
      add(centre(c), b, c + 1, c + 1, a, b);
      break;
    case LatticeValues::CellsLinear:
      c == 0 ? add(a, centre(c), c, c, a, b)
             : add(a, centre(c), c - 1, c, centre(c - 1), centre(c));
      c == last ? add(centre(c), b, c, c, a, b)
                : add(centre(c), b, c, c + 1, centre(c), centre(c + 1));
      break;
    case LatticeValues::CellsNearest:
      add(a, b, c, c, a, b);
      break;
  }
}

std::vector<double> valuesOf(vtkDataArray* coordinates)
{
  std::vector<double> values;
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
  {
    values.push_back(coordinates->GetComponent(i, 0));
  }
  return values;
}
} // namespace

LatticeChords::LatticeChords(vtkDataSet* data, LatticeValues values)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    this->readImage(image, values);
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    this->readRectilinear(grid, values);
  }
  else
  {
    throw std::invalid_argument("LatticeChords takes images and rectilinear grids only");
  }
}

// A point is at the origin plus the direction matrix times spacing times index, component by
// component: the inverse of that gives indices, counted from the first one of the extent.
void LatticeChords::readImage(vtkImageData* image, LatticeValues values)
{
  int extent[6];
  image->GetExtent(extent);
  const double* spacing = image->GetSpacing();
  std::array<Vec3l, 3> columns;
  for (int a = 0; a < 3; ++a)
  {
    std::vector<double> points(std::max(extent[2 * a + 1] - extent[2 * a] + 1, 0));
    std::iota(points.begin(), points.end(), 0.0);
    this->cutAxis(a, points, values);
    for (int row = 0; row < 3; ++row)
    {
      columns[a][row] =
        static_cast<long double>(image->GetDirectionMatrix()->GetElement(row, a)) * spacing[a];
    }
  }
  const long double volume = dot(columns[0], cross(columns[1], columns[2]));
  if (volume == 0.0L)
  {
    throw std::invalid_argument("The image's cells have no volume");
  }
  for (int a = 0; a < 3; ++a)
  {
    this->Rows[a] = cross(columns[(a + 1) % 3], columns[(a + 2) % 3]);
    this->Origin[a] = image->GetOrigin()[a];
    for (int k = 0; k < 3; ++k)
    {
      this->Rows[a][k] /= volume;
      this->Origin[a] += columns[k][a] * extent[2 * k];
    }
  }
}

void LatticeChords::readRectilinear(vtkRectilinearGrid* grid, LatticeValues values)
{
  this->cutAxis(0, valuesOf(grid->GetXCoordinates()), values);
  this->cutAxis(1, valuesOf(grid->GetYCoordinates()), values);
  this->cutAxis(2, valuesOf(grid->GetZCoordinates()), values);
  this->Rows = { { { 1.0L, 0.0L, 0.0L }, { 0.0L, 1.0L, 0.0L }, { 0.0L, 0.0L, 1.0L } } };
}

void LatticeChords::cutAxis(int axis, const std::vector<double>& points, LatticeValues values)
{
  const int cells = static_cast<int>(points.size()) - 1;
  this->Cells[axis] = cells;
  this->Counts[axis] = isOfCells(values) ? cells : cells + 1;
  for (int c = 0; c < cells; ++c)
  {
    addSlabs(points, c, values,
      [&](double a, double b, int first, int second, double place, double next)
      {
        if (a != b)
        {
          this->Slabs[axis].push_back({ { a, b }, c, { first, second }, { place, next } });
        }
      });
  }
  if (this->Slabs[axis].empty())
  {
    throw std::invalid_argument("The data is flat: it has no cells along an axis");
  }
}

// Where the line is within each slab: T0 > T1 if nowhere.
std::vector<LatticeChords::Interval> LatticeChords::intervalsOf(
  int axis, long double origin, long double direction) const
{
  const long double infinity = std::numeric_limits<long double>::infinity();
  const auto greatest = [&](const LatticeSlab& slab)
  { return std::max(slab.Planes[0], slab.Planes[1]); };
  double end = -RayChords::Infinity;
  for (const LatticeSlab& slab : this->Slabs[axis])
  {
    end = std::max(end, greatest(slab));
  }
  std::vector<Interval> intervals;
  for (const LatticeSlab& slab : this->Slabs[axis])
  {
    if (direction != 0.0L)
    {
      const long double a = (slab.Planes[0] - origin) / direction;
      const long double b = (slab.Planes[1] - origin) / direction;
      intervals.push_back({ std::min(a, b), std::max(a, b) });
      continue;
    }
    const double high = greatest(slab);
    const double low = std::min(slab.Planes[0], slab.Planes[1]);
    const bool inside = origin >= low && (origin < high || (high == end && origin == end));
    intervals.push_back(inside ? Interval{ -infinity, infinity } : Interval{ infinity, -infinity });
  }
  return intervals;
}

std::vector<LatticeChord> LatticeChords::find(const Ray& ray, double tMin, double tMax) const
{
  const Vec3l direction = { ray.Direction[0], ray.Direction[1], ray.Direction[2] };
  const long double length = std::sqrt(dot(direction, direction));
  Vec3l from;
  for (int a = 0; a < 3; ++a)
  {
    from[a] = ray.Origin[a] - this->Origin[a];
  }
  Vec3l origin;
  Vec3l step;
  std::vector<Interval> within[3];
  for (int a = 0; a < 3; ++a)
  {
    origin[a] = dot(this->Rows[a], from);
    step[a] = dot(this->Rows[a], direction) / length;
    within[a] = this->intervalsOf(a, origin[a], step[a]);
  }
  const auto both = [](const Interval& a, const Interval& b) {
    return Interval{ std::max(a.T0, b.T0), std::min(a.T1, b.T1) };
  };

  std::vector<LatticeChord> chords;
  const auto add = [&](const std::array<int, 3>& slabs, const Interval& part)
  {
    LatticeChord chord;
    chord.Slabs = slabs;
    chord.T0 = static_cast<double>(part.T0);
    chord.T1 = static_cast<double>(part.T1);
    if (!(chord.T0 < chord.T1))
    {
      return;
    }
    for (int a = 0; a < 3; ++a)
    {
      const LatticeSlab& slab = this->Slabs[a][slabs[a]];
      const long double low = std::min(slab.Planes[0], slab.Planes[1]);
      const long double high = std::max(slab.Planes[0], slab.Planes[1]);
      const auto place = [&](long double t)
      {
        const long double x = std::clamp(origin[a] + t * step[a], low, high);
        return (x - slab.Places[0]) / (static_cast<long double>(slab.Places[1]) - slab.Places[0]);
      };
      chord.Begin[a] = place(part.T0);
      chord.End[a] = place(part.T1);
    }
    chords.push_back(chord);
  };
  for (std::size_t k = 0; k < within[2].size(); ++k)
  {
    const Interval inLayer = both({ tMin, tMax }, within[2][k]);
    for (std::size_t j = 0; inLayer.T0 < inLayer.T1 && j < within[1].size(); ++j)
    {
      const Interval inRow = both(inLayer, within[1][j]);
      for (std::size_t i = 0; inRow.T0 < inRow.T1 && i < within[0].size(); ++i)
      {
        const Interval part = both(inRow, within[0][i]);
        if (part.T0 < part.T1)
        {
          add({ static_cast<int>(i), static_cast<int>(j), static_cast<int>(k) }, part);
        }
      }
    }
  }
  std::sort(chords.begin(), chords.end(),
    [](const LatticeChord& a, const LatticeChord& b) { return a.T0 < b.T0; });
  return chords;
}
} // namespace tetmarch::testing
