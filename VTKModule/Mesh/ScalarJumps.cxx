// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/ScalarJumps.h"

#include "Mesh/TupleValues.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

// One of the drawn scalars; `number` is 0 for the first, and counts extra ones.
bool jumps(const DrawnScalars& drawn, const TetMesh& mesh, std::size_t number)
{
  const std::vector<Id> points = pointsOfSolids(mesh);
  const std::vector<double> values = scalarsOf(
    drawn.Array, points, number == 0 ? drawn.First : TupleScalar{ false, drawn.Extra[number - 1] });
  const ScalarRange range =
    number < drawn.Whole.size() ? drawn.Whole[number].range() : finiteRange(values);
  std::vector<float> stored(mesh.FirstPoints.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Id first = mesh.FirstPoints[points[i]];
    stored[points[i]] = storedScalar(values[i], range);
    if (stored[points[i]] != stored[first]) // the first one comes before
    {
      return true;
    }
  }
  return false;
}

} // namespace

std::vector<Id> pointsOfSolids(const TetMesh& mesh)
{
  std::vector<Id> points;
  points.reserve(mesh.FirstPoints.size());
  for (std::size_t i = 0; i < mesh.FirstPoints.size(); ++i)
  {
    if (mesh.FirstPoints[i] != NoPoint)
    {
      points.push_back(static_cast<Id>(i));
    }
  }
  return points;
}

bool scalarsJump(const DrawnScalars& drawn, const TetMesh& mesh)
{
  if (mesh.FirstPoints.empty() || drawn.OfCells || !drawn.Array)
  {
    return false;
  }
  bool any = false;
  for (std::size_t i = 0; i <= drawn.Extra.size() && !any; ++i)
  {
    any = jumps(drawn, mesh, i);
  }
  return any;
}

} // namespace tetmarch
