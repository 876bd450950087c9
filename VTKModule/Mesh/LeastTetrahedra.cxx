// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/LeastTetrahedra.h"

#include "Input/CellShapes.h"
#include "Input/CellTypes.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace tetmarch
{
namespace
{

constexpr int Types = 256;

int trianglesOf(const Polygon& face) { return static_cast<int>(face.size()) - 2; }

// Number of triangles of the faces that do not contain the point, if it is a corner of the piece.
int trianglesAwayFrom(int point, const CellPiece& piece)
{
  int count = 0;
  for (const Polygon& face : piece.Faces)
  {
    const bool touches = std::find(face.begin(), face.end(), point) != face.end();
    count += touches ? 0 : trianglesOf(face);
  }
  return count;
}

int leastOf(const CellPiece& piece)
{
  if (piece.Apex != ApexSmallestId)
  {
    return trianglesAwayFrom(piece.Apex, piece);
  }
  int least = std::numeric_limits<int>::max();
  for (const Polygon& face : piece.Faces)
  {
    for (const int point : face)
    {
      least = std::min(least, trianglesAwayFrom(point, piece));
    }
  }
  return least;
}

std::array<int, Types> makeTable()
{
  std::array<int, Types> table{};
  for (int type = 0; type < Types; ++type)
  {
    const std::vector<CellPiece>* pieces = cellPieces(type);
    for (std::size_t i = 0; pieces && i < pieces->size(); ++i)
    {
      table[type] += leastOf((*pieces)[i]);
    }
  }
  table[VTK_TETRA] = 1;
  table[VTK_POLYHEDRON] = 1;
  return table;
}

template <typename Range>
bool repeats(const Range& ids, vtkIdType begin, vtkIdType end)
{
  for (vtkIdType i = begin; i < end; ++i)
  {
    for (vtkIdType j = begin; j < i; ++j)
    {
      if (ids[i] == ids[j])
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace

int leastTetrahedraOfType(int cellType)
{
  static const std::array<int, Types> table = makeTable();
  return cellType >= 0 && cellType < Types ? table[cellType] : 0;
}

std::uint64_t leastTetrahedra(vtkUnstructuredGrid* grid, std::uint64_t enough)
{
  const CellTypes types(grid);
  vtkCellArray* cells = grid->GetCells();
  const vtkIdType count = types.array() ? types.array()->GetNumberOfTuples() : 0;
  if (!cells || count != cells->GetNumberOfCells())
  {
    return 0;
  }
  std::uint64_t sum = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    sum += leastTetrahedraOfType(types[i]);
  }
  if (sum <= enough)
  {
    return sum;
  }
  const auto offsets = vtk::DataArrayValueRange<1>(cells->GetOffsetsArray());
  const auto ids = vtk::DataArrayValueRange<1>(cells->GetConnectivityArray());
  const auto size = static_cast<double>(ids.size());
  sum = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const int least = leastTetrahedraOfType(types[i]);
    const double begin = offsets[i];
    const double end = offsets[i + 1];
    if (least > 0 && 0 <= begin && begin + 4 <= end && end <= size &&
        !repeats(ids, static_cast<vtkIdType>(begin), static_cast<vtkIdType>(end)))
    {
      sum += least;
    }
  }
  return sum;
}

} // namespace tetmarch
