// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/CurvedTolerance.h"

#include "vtkDataArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

constexpr double TestedAt[] = { 0.25, 0.5, 0.75 };
// An edge of 1/64 of a cell's is no longer tested: functions that are no polynomials end here.
constexpr float ShortestTested = 1.0F / 64;
// Of shape functions, in parts of the greatest value; scalars that are all alike differ by it.
constexpr double RoundingOfValues = 1e-13;

} // namespace

CurvedTolerance toleranceOf(
  vtkUnstructuredGrid* grid, vtkDataArray* scalars, double partOfDiagonal, double partOfRange)
{
  CurvedTolerance tolerance{ partOfDiagonal * grid->GetLength(), scalars, {} };
  for (int c = 0; scalars && c < scalars->GetNumberOfComponents(); ++c)
  {
    double range[2];
    scalars->GetFiniteRange(range, c);
    const double greatest = std::max(std::abs(range[0]), std::abs(range[1]));
    tolerance.Values.push_back(
      std::max(partOfRange * (range[1] - range[0]), RoundingOfValues * greatest));
  }
  return tolerance;
}

bool leavesTolerance(const CurvedTolerance& tolerance, const PieceCorner& a, const PieceCorner& b,
  const OutputPoints& points, CurvedCell& cell, CurvedPlace& place)
{
  const auto isShort = [&](int k) { return std::abs(a.At[k] - b.At[k]) < ShortestTested; };
  if (isShort(0) && isShort(1) && isShort(2))
  {
    return false;
  }
  const Vector3 begin = points.position(a.Point.Id);
  const Vector3 along = points.position(b.Point.Id) - begin;
  const double length2 = dot(along, along);
  for (const double t : TestedAt)
  {
    Vector3 at = scaled(1 - t, a.place());
    tetmarch::add(t, b.place(), at);
    cell.evaluate(at, place);
    // Its value is compared with that of the nearest point of the straight edge.
    Vector3 apart = place.Position - begin;
    const double share = length2 > 0 ? dot(apart, along) / length2 : t;
    tetmarch::add(-share, along, apart);
    if (std::sqrt(dot(apart, apart)) > tolerance.Distance)
    {
      return true;
    }
    for (std::size_t c = 0; c < tolerance.Values.size(); ++c)
    {
      const double straight =
        (1 - share) * points.value(a.Point.Id, c) + share * points.value(b.Point.Id, c);
      if (std::abs(place.Values[c] - straight) > tolerance.Values[c])
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace tetmarch
