// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Convexity.h"

#include "Mesh/BoundaryEdges.h"
#include "Mesh/FacePlane.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

bool isConcaveOrFold(const TetMesh& mesh, const BoundaryEdge& a, const BoundaryEdge& b)
{
  const double rounding = std::ldexp(1.0, -22);
  const FacePlane planeA(mesh, a.Face), planeB(mesh, b.Face);
  const double heightB = planeA.heightOf(mesh.Vertices[b.Opposite]);
  const double heightA = planeB.heightOf(mesh.Vertices[a.Opposite]);
  if (heightA > rounding || heightB > rounding)
  {
    return true;
  }
  const bool even = heightA >= -rounding && heightB >= -rounding;
  double cosine = 0;
  for (int k = 0; k < 3; ++k)
  {
    cosine += planeA.Normal[k] * planeB.Normal[k];
  }
  return even && cosine < 0;
}

bool isNeedle(const TetMesh& mesh, const std::array<Id, 4>& face)
{
  std::array<std::array<double, 3>, 3> p;
  for (int i = 0; i < 3; ++i)
  {
    const Vertex& v = mesh.Vertices[face[i]];
    p[i] = { { double(v.X), double(v.Y), double(v.Z) } };
  }
  double longest = 0;
  double area = 0; // squared, of the parallelogram
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    double square = 0;
    for (int k = 0; k < 3; ++k)
    {
      square += (p[j][k] - p[i][k]) * (p[j][k] - p[i][k]);
    }
    longest = std::max(longest, square);
    const int l = i, m = j;
    const double component =
      (p[1][l] - p[0][l]) * (p[2][m] - p[0][m]) - (p[1][m] - p[0][m]) * (p[2][l] - p[0][l]);
    area += component * component;
  }
  // Height is area / longest edge; all are squared.
  return !(area > std::ldexp(longest, -36) && area > std::ldexp(longest * longest, -12));
}

// Whether a vertex of the boundary is clearly beyond one of 16 faces. That suffices for most meshes
// that aren't convex.
bool isClearlyConcave(const TetMesh& mesh)
{
  const auto& faces = mesh.BoundaryFaces;
  const double clearly = std::ldexp(1.0, -12);
  const std::size_t step = faces.size() / 16 + 1;
  for (std::size_t f = 0; f < faces.size(); f += step)
  {
    const FacePlane plane(mesh, static_cast<Id>(f));
    if (std::any_of(faces.begin(), faces.end(),
          [&](const std::array<Id, 4>& face)
          { return plane.heightOf(mesh.Vertices[face[0]]) > clearly; }))
    {
      return true;
    }
  }
  return false;
}

} // namespace

bool isConvex(const TetMesh& mesh)
{
  if (isClearlyConcave(mesh))
  {
    return false;
  }
  if (std::any_of(mesh.BoundaryFaces.begin(), mesh.BoundaryFaces.end(),
        [&](const std::array<Id, 4>& face) { return isNeedle(mesh, face); }))
  {
    return false;
  }
  const std::vector<BoundaryEdge> edges = sortedBoundaryEdges(mesh);
  FaceSets surfaces(mesh.BoundaryFaces.size());
  for (std::size_t e = 0; e < edges.size(); e += 2)
  {
    if (pairOf(edges, e) != EdgePair::Regular || isConcaveOrFold(mesh, edges[e], edges[e + 1]))
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
