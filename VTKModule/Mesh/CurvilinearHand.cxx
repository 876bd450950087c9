// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CurvilinearHand.h"

#include "Geometry/Vector3.h"
#include "Mesh/Orientation.h"

#include <algorithm>
#include <atomic>

namespace tetmarch
{
namespace
{

// Whether the six tetrahedra of the hexahedron with this lowest vertex are of that hand. The paths
// from the lowest vertex to the highest one along axes a, b, c and b, a, c share the diagonal of a
// face.
bool isOfHand(int hand, const Vertex* low, const std::array<Id, 3>& strides)
{
  const Vector3 origin = position(*low);
  const auto to = [&](Id offset) { return position(low[offset]) - origin; };
  const Vector3 end = to(strides[0] + strides[1] + strides[2]);
  const std::array<Vector3, 3> edges{ { to(strides[0]), to(strides[1]), to(strides[2]) } };
  const double squareOfEnd = dot(end, end);
  for (int a = 0; a < 3; ++a)
  {
    const int b = (a + 1) % 3;
    const Vector3 diagonal = to(strides[a] + strides[b]);
    const Vector3 normal = cross(diagonal, end);
    const double square = std::max(dot(diagonal, diagonal), squareOfEnd);
    const auto exceeds = [&](double volume, const Vector3& edge)
    { return volume > volumeRounding(std::max(square, dot(edge, edge))); };
    if (!exceeds(hand * dot(edges[a], normal), edges[a]) ||
        !exceeds(-hand * dot(edges[b], normal), edges[b]))
    {
      return false;
    }
  }
  return true;
}

} // namespace

int handOf(const TetMesh& mesh, const Progress& progress, bool& unfinished)
{
  const int hand = volumeSign(mesh, 0); // whose path goes along i, j and k
  const std::array<Id, 3>& cells = mesh.Curvilinear->cells();
  const std::array<Id, 3> strides = mesh.Curvilinear->pointStrides();
  std::atomic<bool> agree(hand != 0);
  unfinished = !parallelFor(static_cast<vtkIdType>(cells[0]) * cells[1] * cells[2], progress,
    [&](vtkIdType first, vtkIdType last)
    {
      while (first < last && agree) // the rest of a row of cells
      {
        const vtkIdType row = first / cells[0], i = first % cells[0];
        const vtkIdType count = std::min(last - first, cells[0] - i);
        const Vertex* low =
          &mesh.Vertices[i + strides[1] * (row % cells[1]) + strides[2] * (row / cells[1])];
        if (!std::all_of(
              low, low + count, [&](const Vertex& v) { return isOfHand(hand, &v, strides); }))
        {
          agree = false;
        }
        first += count;
      }
    });
  return agree ? hand : 0;
}

} // namespace tetmarch
