// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Convexity.h"

#include "BoundaryEdges.h"
#include "FacePlane.h"

#include <cmath>

namespace tetmarch
{
namespace
{

bool isConcave(const TetMesh& mesh, const BoundaryEdge& a, const BoundaryEdge& b)
{
  const double rounding = std::ldexp(1.0, -22);
  return FacePlane(mesh, a.Face).heightOf(mesh.Vertices[b.Opposite]) > rounding ||
         FacePlane(mesh, b.Face).heightOf(mesh.Vertices[a.Opposite]) > rounding;
}

} // namespace

bool isConvex(const TetMesh& mesh)
{
  const std::vector<BoundaryEdge> edges = sortedBoundaryEdges(mesh);
  FaceSets surfaces(mesh.BoundaryFaces.size());
  for (std::size_t e = 0; e < edges.size(); e += 2)
  {
    if (pairOf(edges, e) != EdgePair::Regular || isConcave(mesh, edges[e], edges[e + 1]))
    {
      return false;
    }
    surfaces.join(edges[e].Face, edges[e + 1].Face);
  }
  for (Id f = 1; f < mesh.BoundaryFaces.size(); ++f)
  {
    if (surfaces.rootOf(f) != surfaces.rootOf(0))
    {
      return false;
    }
  }
  return true;
}

} // namespace tetmarch
