// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Convexity.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetmarch
{
namespace
{

struct Edge
{
  std::uint64_t Key; // smaller vertex, then larger
  Id Face;
  Id Opposite; // the face's third vertex
};

using Position = std::array<double, 3>;

Position minus(const Vertex& a, const Vertex& b)
{
  return { { double(a.X) - double(b.X), double(a.Y) - double(b.Y), double(a.Z) - double(b.Z) } };
}

double dot(const Position& a, const Position& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// How far a vertex stands out over the plane of a face.
double heightOver(const TetMesh& mesh, Id face, Id vertex)
{
  const auto& f = mesh.BoundaryFaces[face];
  const Vertex& a = mesh.Vertices[f[0]];
  const Position u = minus(mesh.Vertices[f[1]], a);
  const Position v = minus(mesh.Vertices[f[2]], a);
  const Position n{ { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] } };
  const double size = std::sqrt(dot(n, n));
  return size > 0 ? dot(n, minus(mesh.Vertices[vertex], a)) / size : 0;
}

std::vector<Edge> sortedEdges(const TetMesh& mesh)
{
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.BoundaryFaces.size());
  for (Id f = 0; f < mesh.BoundaryFaces.size(); ++f)
  {
    const auto& face = mesh.BoundaryFaces[f];
    for (int i = 0; i < 3; ++i)
    {
      const Id a = face[i], b = face[(i + 1) % 3];
      edges.push_back({ std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), f, face[(i + 2) % 3] });
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.Key < b.Key; });
  return edges;
}

Id findRoot(std::vector<Id>& parent, Id i)
{
  while (parent[i] != i)
  {
    i = parent[i] = parent[parent[i]];
  }
  return i;
}

} // namespace

bool isConvex(const TetMesh& mesh)
{
  const double rounding = std::ldexp(1.0, -22);
  const std::vector<Edge> edges = sortedEdges(mesh);
  std::vector<Id> parent(mesh.BoundaryFaces.size());
  std::iota(parent.begin(), parent.end(), Id(0));
  std::size_t surfaces = parent.size();
  for (std::size_t e = 0; e < edges.size(); e += 2)
  {
    const bool paired = e + 1 < edges.size() && edges[e].Key == edges[e + 1].Key &&
      (e + 2 == edges.size() || edges[e + 2].Key != edges[e].Key);
    if (!paired || heightOver(mesh, edges[e].Face, edges[e + 1].Opposite) > rounding ||
      heightOver(mesh, edges[e + 1].Face, edges[e].Opposite) > rounding)
    {
      return false;
    }
    const Id a = findRoot(parent, edges[e].Face), b = findRoot(parent, edges[e + 1].Face);
    surfaces -= a != b ? 1 : 0;
    parent[a] = b;
  }
  return surfaces <= 1;
}

} // namespace tetmarch
