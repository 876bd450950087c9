// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/LinearParts.h"

#include "vtkCellType.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderWedge.h"

namespace tetmarch
{
namespace
{

std::vector<std::vector<int>> partsOfHexahedron(const CellDegrees& n)
{
  const auto at = [&n](int i, int j, int k)
  { return vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, n.data()); };
  std::vector<std::vector<int>> parts;
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        parts.push_back({ at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
          at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1) });
      }
    }
  }
  return parts;
}

// At (i, j) a triangle with a corner there, and its neighbour across the side opposite that corner.
std::vector<std::vector<int>> partsOfWedge(const CellDegrees& n)
{
  const auto at = [&n](int i, int j, int k)
  { return vtkHigherOrderWedge::PointIndexFromIJK(i, j, k, n.data()); };
  std::vector<std::vector<int>> parts;
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[0]; ++j)
    {
      for (int i = 0; i + j < n[0]; ++i)
      {
        parts.push_back({ at(i, j, k), at(i + 1, j, k), at(i, j + 1, k), at(i, j, k + 1),
          at(i + 1, j, k + 1), at(i, j + 1, k + 1) });
        if (i + j + 1 < n[0])
        {
          parts.push_back({ at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
            at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1) });
        }
      }
    }
  }
  return parts;
}

} // namespace

bool isHigherOrderWedge(int cellType)
{
  return cellType == VTK_LAGRANGE_WEDGE || cellType == VTK_BEZIER_WEDGE;
}

bool isHigherOrderHexahedron(int cellType)
{
  return cellType == VTK_LAGRANGE_HEXAHEDRON || cellType == VTK_BEZIER_HEXAHEDRON;
}

LinearParts linearParts(int cellType, const CellDegrees& degrees)
{
  return isHigherOrderWedge(cellType) ? LinearParts{ VTK_WEDGE, partsOfWedge(degrees) }
                                      : LinearParts{ VTK_HEXAHEDRON, partsOfHexahedron(degrees) };
}

} // namespace tetmarch
