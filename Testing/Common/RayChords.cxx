// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RayChords.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tetmarch::testing
{
namespace
{
using Vec3l = std::array<long double, 3>;

Vec3l minus(const Vec3& a, const Vec3& b)
{
  return { static_cast<long double>(a[0]) - b[0], static_cast<long double>(a[1]) - b[1],
    static_cast<long double>(a[2]) - b[2] };
}

Vec3l minus(const Vec3l& a, const Vec3l& b) { return { a[0] - b[0], a[1] - b[1], a[2] - b[2] }; }

long double dot(const Vec3l& a, const Vec3l& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec3l cross(const Vec3l& a, const Vec3l& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double distance(const Vec3& a, const Vec3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Vec3 normalised(const Vec3& d)
{
  const double length = distance(d, { 0.0, 0.0, 0.0 });
  return { d[0] / length, d[1] / length, d[2] / length };
}

// May the line meet the ball? With room for the rounding of a far origin.
bool mayMeet(const std::array<double, 4>& sphere, const Vec3& origin, const Vec3& unit)
{
  const Vec3 toCentre = { sphere[0] - origin[0], sphere[1] - origin[1], sphere[2] - origin[2] };
  const double along = toCentre[0] * unit[0] + toCentre[1] * unit[1] + toCentre[2] * unit[2];
  const Vec3 aside = { toCentre[0] - along * unit[0], toCentre[1] - along * unit[1],
    toCentre[2] - along * unit[2] };
  const double reach = sphere[3] * (1.0 + 1e-9) + 1e-14 * std::abs(along);
  return aside[0] * aside[0] + aside[1] * aside[1] + aside[2] * aside[2] <= reach * reach;
}

// Keep the part [s0, s1] (by length from T0) of a chord.
void shorten(Chord& chord, double t0, double t1)
{
  const double length = chord.T1 - chord.T0;
  const double a = std::clamp((t0 - chord.T0) / length, 0.0, 1.0);
  const double b = std::clamp((t1 - chord.T0) / length, 0.0, 1.0);
  const Chord whole = chord;
  for (int i = 0; i < 4; ++i)
  {
    chord.W0[i] = (1.0 - a) * whole.W0[i] + a * whole.W1[i];
    chord.W1[i] = (1.0 - b) * whole.W0[i] + b * whole.W1[i];
  }
  chord.T0 = t0;
  chord.T1 = t1;
}
} // namespace

RayChords::RayChords(vtkUnstructuredGrid* grid)
{
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    Vec3 p;
    grid->GetPoint(i, p.data());
    this->Points.push_back(p);
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) != VTK_TETRA)
    {
      throw std::invalid_argument("RayChords takes tetrahedra only");
    }
    grid->GetCells()->GetCellAtId(cell, ids);
    Vec3 centre = { 0.0, 0.0, 0.0 };
    for (int i = 0; i < 4; ++i)
    {
      this->Corners.push_back(ids->GetId(i));
      for (int a = 0; a < 3; ++a)
      {
        centre[a] += 0.25 * this->Points[ids->GetId(i)][a];
      }
    }
    double radius = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      radius = std::max(radius, distance(centre, this->Points[ids->GetId(i)]));
    }
    this->Spheres.push_back({ centre[0], centre[1], centre[2], radius });
  }
}

std::vector<Chord> RayChords::find(const Ray& ray, double tMin, double tMax) const
{
  const Vec3 unit = normalised(ray.Direction);
  std::vector<Chord> chords;
  for (std::size_t cell = 0; cell < this->Spheres.size(); ++cell)
  {
    if (!mayMeet(this->Spheres[cell], ray.Origin, unit))
    {
      continue;
    }
    Chord chord = this->clip(static_cast<vtkIdType>(cell), ray.Origin, unit);
    const double t0 = std::max(chord.T0, tMin);
    const double t1 = std::min(chord.T1, tMax);
    if (t0 < t1)
    {
      shorten(chord, t0, t1);
      chords.push_back(chord);
    }
  }
  std::sort(
    chords.begin(), chords.end(), [](const Chord& a, const Chord& b) { return a.T0 < b.T0; });
  return chords;
}

// Inside, every barycentric coordinate is positive; along the line each is linear in t.
Chord RayChords::clip(vtkIdType cell, const Vec3& origin, const Vec3& unit) const
{
  Vec3l v[4];
  for (int i = 0; i < 4; ++i)
  {
    v[i] = minus(this->Points[this->pointOf(cell, i)], origin);
  }
  const Vec3l d = { unit[0], unit[1], unit[2] };
  const long double volume = dot(minus(v[1], v[0]), cross(minus(v[2], v[0]), minus(v[3], v[0])));

  Chord none;
  none.Cell = cell;
  if (volume == 0.0L)
  {
    return none;
  }
  long double value[4];
  long double slope[4];
  long double t0 = -std::numeric_limits<long double>::infinity();
  long double t1 = -t0;
  for (int i = 0; i < 4; ++i)
  {
    const Vec3l& base = v[(i + 1) % 4];
    const Vec3l normal = cross(minus(v[(i + 2) % 4], base), minus(v[(i + 3) % 4], base));
    const long double height = dot(normal, minus(v[i], base));
    value[i] = -dot(normal, base) / height;
    slope[i] = dot(normal, d) / height;
    if (slope[i] > 0.0L)
    {
      t0 = std::max(t0, -value[i] / slope[i]);
    }
    else if (slope[i] < 0.0L)
    {
      t1 = std::min(t1, -value[i] / slope[i]);
    }
    else if (!(value[i] >= 0.0L))
    {
      return none;
    }
  }
  if (!(t0 < t1))
  {
    return none;
  }
  Chord chord;
  chord.Cell = cell;
  chord.T0 = static_cast<double>(t0);
  chord.T1 = static_cast<double>(t1);
  for (int i = 0; i < 4; ++i)
  {
    chord.W0[i] = static_cast<double>(value[i] + t0 * slope[i]);
    chord.W1[i] = static_cast<double>(value[i] + t1 * slope[i]);
  }
  return chord;
}

std::vector<Chord> RayChords::withoutOverlap(std::vector<Chord> sorted)
{
  std::vector<Chord> kept;
  double done = -Infinity;
  for (Chord& chord : sorted)
  {
    const double t0 = std::max(chord.T0, done);
    if (t0 < chord.T1)
    {
      shorten(chord, t0, chord.T1);
      done = chord.T1;
      kept.push_back(chord);
    }
  }
  return kept;
}
} // namespace tetmarch::testing
