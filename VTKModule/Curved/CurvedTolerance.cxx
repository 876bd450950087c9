// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/CurvedTolerance.h"

#include "vtkDataArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetmarch
{
namespace
{

constexpr double TestedAt[] = { 0.25, 0.5, 0.75 };
// An edge below 1/64 of a cell's keeps any tolerance: functions that are no polynomials end here.
constexpr float ShortestTested = 1.0F / 64;
// Of shape functions, in parts of the greatest value; scalars that are all alike differ by it.
constexpr double RoundingOfValues = 1e-13;

bool isLong(const PieceCorner& a, const PieceCorner& b)
{
  const auto isFar = [&](int k) { return std::abs(a.At[k] - b.At[k]) >= ShortestTested; };
  return isFar(0) || isFar(1) || isFar(2);
}

// Tolerances may be 0.
double partOf(double tolerance, double difference)
{
  return difference > 0 ? difference / tolerance : 0;
}

double magnitudeOf(const std::vector<double>& values)
{
  return std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.0));
}

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
  const OutputPoints& points, CurvedCell& cell, CurvedPlace& place, EdgeDeparture* departure)
{
  const bool isTested = isLong(a, b);
  if (!isTested && !departure)
  {
    return false;
  }
  const Vector3 begin = points.position(a.Point.Id);
  const Vector3 along = points.position(b.Point.Id) - begin;
  const double length2 = dot(along, along);
  double farthest = -1;
  for (const double t : TestedAt)
  {
    Vector3 at = scaled(1 - t, a.place());
    tetmarch::add(t, b.place(), at);
    cell.evaluate(at, place);
    // Its value is compared with that of the nearest point of the straight edge.
    Vector3 apart = place.Position - begin;
    const double share = length2 > 0 ? dot(apart, along) / length2 : t;
    tetmarch::add(-t, along, apart);
    Vector3 across = apart;
    tetmarch::add(t - share, along, across);
    double off = partOf(tolerance.Distance, std::sqrt(dot(across, across)));
    for (std::size_t c = 0; c < tolerance.Values.size(); ++c)
    {
      const double first = points.value(a.Point.Id, c);
      const double rise = points.value(b.Point.Id, c) - first;
      const double difference = place.Values[c] - first - share * rise;
      off = std::max(off, partOf(tolerance.Values[c], std::abs(difference)));
    }
    if (off > 1 && isTested)
    {
      return true;
    }
    if (departure)
    {
      const double magnitude = magnitudeOf(place.Values) - (1 - t) * points.magnitude(a.Point.Id) -
                               t * points.magnitude(b.Point.Id);
      off = std::max(off, partOf(magnitudeOf(tolerance.Values), std::abs(magnitude)));
      if (off > farthest)
      {
        farthest = off;
        departure->Apart = apart;
        departure->Values = place.Values;
        for (std::size_t c = 0; c < departure->Values.size(); ++c)
        {
          departure->Values[c] -=
            (1 - t) * points.value(a.Point.Id, c) + t * points.value(b.Point.Id, c);
        }
        departure->Magnitude = magnitude;
      }
    }
  }
  return false;
}

} // namespace tetmarch
