// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/VertexStarts.h"

#include "Geometry/Vector3.h"
#include "Mesh/Orientation.h"
#include "Mesh/OutsideSigns.h"
#include "Mesh/VertexTets.h"
#include "Parallel/ParallelFor.h"

#include <cmath>
#include <utility>

namespace tetmarch
{
namespace
{

// The radius of the inscribed sphere: three times the volume over the area of the surface.
double inscribedRadius(const TetMesh& mesh, Id t)
{
  const auto& tet = mesh.Tets[t];
  const auto doubleArea = [&](int i, int j, int k)
  {
    const Vector3 o = position(mesh.Vertices[tet[i]]);
    const Vector3 normal =
      cross(position(mesh.Vertices[tet[j]]) - o, position(mesh.Vertices[tet[k]]) - o);
    return std::sqrt(dot(normal, normal));
  };
  const double areas =
    doubleArea(0, 1, 2) + doubleArea(0, 1, 3) + doubleArea(0, 2, 3) + doubleArea(1, 2, 3);
  return areas > 0 ? std::abs(signedVolume(mesh, t)) / areas : 0;
}

std::vector<double> inscribedRadii(const TetMesh& mesh)
{
  std::vector<double> radii(mesh.Tets.size());
  parallelFor(0, static_cast<vtkIdType>(radii.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType t = first; t < last; ++t)
      {
        radii[t] = inscribedRadius(mesh, static_cast<Id>(t));
      }
    });
  return radii;
}

std::array<Id, 4> startIn(const TetMesh& mesh, Id vertex, Id t, int sign)
{
  const auto& tet = mesh.Tets[t];
  std::array<Id, 4> start{ { 0, 0, 0, t } };
  int next = 0;
  int rank = 0;
  for (int i = 0; i < 4; ++i)
  {
    if (tet[i] == vertex)
    {
      rank = i;
    }
    else
    {
      start[next++] = tet[i];
    }
  }
  // Moving the vertex before the others takes `rank` exchanges. If their number is even and the
  // sign is 1, the last vertex sees the first three counter-clockwise, and outside is on the other
  // side.
  if (sign * (rank % 2 == 0 ? 1 : -1) > 0)
  {
    std::swap(start[1], start[2]);
  }
  start[2] = mesh.Links[4 * std::size_t(t) + 3];
  return start;
}

} // namespace

std::vector<std::array<Id, 4>> vertexStarts(const TetMesh& mesh)
{
  const VertexTets around(mesh);
  const std::vector<double> radii = inscribedRadii(mesh);
  const std::vector<std::int8_t> signs = outsideSigns(mesh);
  std::vector<std::array<Id, 4>> starts(mesh.Vertices.size(), { { 0, 0, 0, NoTet } });
  parallelFor(0, static_cast<vtkIdType>(starts.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const auto v = static_cast<Id>(i);
        Id best = NoTet;
        for (const Id* t = around.begin(v); t != around.end(v); ++t)
        {
          if (best == NoTet || radii[*t] > radii[best])
          {
            best = *t;
          }
        }
        if (best != NoTet)
        {
          starts[i] = startIn(mesh, v, best, signs[best]);
        }
      }
    });
  return starts;
}

bool startPoint(
  const TetMesh& mesh, std::size_t vertex, const std::array<Id, 4>& start, Vector3& point)
{
  if (start[3] == NoTet)
  {
    return false;
  }
  point = scaled(1 - 1.0 / 64, position(mesh.Vertices[vertex]));
  for (const Id v : { start[0], start[1], fourthVertex(mesh, static_cast<Id>(vertex), start) })
  {
    add(1.0 / (3 * 64), position(mesh.Vertices[v]), point);
  }
  return true;
}

} // namespace tetmarch
