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

// Whether the six tetrahedra of the hexahedron with this lowest vertex are of that hand, if its
// points are vertices of their own. The paths from the lowest vertex to the highest one along axes
// a, b, c and b, a, c share the diagonal of a face.
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

// Whether a point of the cell shares its vertex with another point of the grid.
bool isJoined(const CurvilinearCells& cells, const std::array<Id, 3>& cell)
{
  const JoinedSides& joins = cells.joins();
  bool joined = false;
  for (int a = 0; a < 3; ++a)
  {
    const bool isFirst = cell[a] == 0, isLast = cell[a] + 1 == cells.cells()[a];
    joined = joined || (isFirst && joins.Poles[2 * a] != 0) ||
             (isLast && (joins.Rings[a] || joins.Poles[2 * a + 1] != 0));
  }
  return joined;
}

// The same of the tetrahedra that are not degenerate, in a cell with joined points.
bool isOfHand(int hand, const TetMesh& mesh, std::size_t cell)
{
  const CurvilinearCells& cells = *mesh.Curvilinear;
  for (Id i = 0; i < CurvilinearCells::TetsOfCell; ++i)
  {
    const auto tet = static_cast<Id>(CurvilinearCells::TetsOfCell * cell + i);
    if (!cells.isDegenerate(tet) && volumeSign(mesh, tet) != hand * cells.sign(tet))
    {
      return false;
    }
  }
  return true;
}

// That of the first tetrahedron that is not degenerate.
int firstHand(const TetMesh& mesh)
{
  const CurvilinearCells& cells = *mesh.Curvilinear;
  Id tet = 0;
  while (tet < mesh.numberOfTets() && cells.isDegenerate(tet))
  {
    ++tet;
  }
  return tet < mesh.numberOfTets() ? volumeSign(mesh, tet) * cells.sign(tet) : 0;
}

} // namespace

int handOf(const TetMesh& mesh, const Progress& progress, bool& unfinished)
{
  const int hand = firstHand(mesh);
  const std::array<Id, 3>& cells = mesh.Curvilinear->cells();
  const bool joins = mesh.Curvilinear->joins().any();
  const std::array<Id, 3> strides = mesh.Curvilinear->pointStrides();
  std::atomic<bool> agree(hand != 0);
  unfinished = !parallelFor(static_cast<vtkIdType>(cells[0]) * cells[1] * cells[2], progress,
    [&](vtkIdType first, vtkIdType last)
    {
      while (first < last && agree) // the rest of a row of cells
      {
        const vtkIdType row = first / cells[0], i = first % cells[0];
        const vtkIdType count = std::min(last - first, cells[0] - i);
        const auto j = static_cast<Id>(row % cells[1]), k = static_cast<Id>(row / cells[1]);
        const Vertex* low = &mesh.Vertices[i + strides[1] * j + strides[2] * k];
        for (vtkIdType n = 0; n < count; ++n)
        {
          const std::array<Id, 3> cell{ { static_cast<Id>(i + n), j, k } };
          if (joins && isJoined(*mesh.Curvilinear, cell)
                ? !isOfHand(hand, mesh, static_cast<std::size_t>(first + n))
                : !isOfHand(hand, low + n, strides))
          {
            agree = false;
            break;
          }
        }
        first += count;
      }
    });
  return agree ? hand : 0;
}

} // namespace tetmarch
