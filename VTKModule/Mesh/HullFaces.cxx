// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/HullFaces.h"

#include "Mesh/BoundaryEdges.h"
#include "Mesh/BoundaryHierarchy.h"
#include "Mesh/FacePlane.h"
#include "Parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

// Maximum number of nodes visited for one face. Few are needed except for large flat sides that are
// not parallel to the axes.
constexpr int MostNodes = 256;

// Whether no vertex of the boundary is beyond the plane.
bool isSupporting(const TetMesh& mesh, const FacePlane& plane)
{
  const double rounding = std::ldexp(1.0, -21);
  std::array<Id, MostHierarchyDepth> stack{ { 0 } };
  int waiting = mesh.Hierarchy.empty() ? 0 : 1;
  for (int looked = 0; waiting > 0; ++looked)
  {
    if (looked == MostNodes)
    {
      return false;
    }
    const Id node = stack[--waiting];
    const HierarchyNode& n = mesh.Hierarchy[node];
    double highest = -plane.Offset;
    for (int k = 0; k < 3; ++k)
    {
      highest += plane.Normal[k] * double(n.Center[k]) +
                 std::abs(plane.Normal[k]) * double(n.HalfSize[k] - HierarchyMargin);
    }
    if (highest <= rounding)
    {
      continue;
    }
    if (n.FirstFace < 0)
    {
      stack[waiting++] = static_cast<Id>(n.Second);
      stack[waiting++] = node + 1;
      continue;
    }
    const Id first = static_cast<Id>(n.FirstFace);
    for (Id f = first; f < first + static_cast<Id>(n.Second); ++f)
    {
      for (int i = 0; i < 3; ++i)
      {
        if (plane.heightOf(mesh.Vertices[mesh.BoundaryFaces[f][i]]) > rounding)
        {
          return false;
        }
      }
    }
  }
  return true;
}

enum Place : char
{
  Inside,
  OnHull,
  OnHullFacingIn
};

Place placeOf(const TetMesh& mesh, Id face)
{
  const FacePlane plane(mesh, face);
  if (!plane.hasArea())
  {
    return Inside;
  }
  return isSupporting(mesh, plane)
           ? OnHull
           : (isSupporting(mesh, plane.reversed()) ? OnHullFacingIn : Inside);
}

// Whether the faces on the hull are connected and without a fold.
bool coverOnce(const TetMesh& mesh, const std::vector<char>& places)
{
  const std::vector<BoundaryEdge> edges = sortedBoundaryEdges(mesh);
  FaceSets sets(places.size());
  for (std::size_t e = 0; e + 1 < edges.size(); ++e)
  {
    const EdgePair pair = pairOf(edges, e);
    if (pair == EdgePair::Folded)
    {
      return false;
    }
    if (pair == EdgePair::Regular && places[edges[e].Face] == OnHull &&
        places[edges[e + 1].Face] == OnHull)
    {
      sets.join(edges[e].Face, edges[e + 1].Face);
    }
  }
  const auto first = std::find(places.begin(), places.end(), OnHull) - places.begin();
  for (std::size_t f = first; f < places.size(); ++f)
  {
    if (places[f] == OnHull &&
        sets.rootOf(static_cast<Id>(f)) != sets.rootOf(static_cast<Id>(first)))
    {
      return false;
    }
  }
  return true;
}

} // namespace

std::vector<bool> findHullFaces(const TetMesh& mesh)
{
  const std::size_t count = mesh.BoundaryFaces.size();
  std::vector<char> places(count);
  parallelFor(0, static_cast<vtkIdType>(count),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType f = first; f < last; ++f)
      {
        places[f] = placeOf(mesh, static_cast<Id>(f));
      }
    });
  std::vector<bool> hull(count, false);
  const bool folded = std::find(places.begin(), places.end(), OnHullFacingIn) != places.end();
  if (!folded && coverOnce(mesh, places))
  {
    std::transform(places.begin(), places.end(), hull.begin(), [](char p) { return p == OnHull; });
  }
  return hull;
}

} // namespace tetmarch
