// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Decomposition.h"

#include "Input/CellTypes.h"
#include "Input/DataCheck.h"
#include "Input/GridCheck.h"
#include "Mesh/CellCutter.h"
#include "Mesh/CoincidentPoints.h"
#include "Parallel/HugePages.h"
#include "Parallel/ParallelFor.h"

#include "vtkCellType.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetmarch
{
namespace
{

// A grid of tetrahedra has no faces to be cut.
bool isCut(vtkUnstructuredGrid* grid)
{
  const CellTypes types(grid);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (types[cell] != VTK_TETRA)
    {
      return true;
    }
  }
  return false;
}

// The rank of each point of a grid by its coordinates, x first.
std::vector<Id> orderByCoordinates(vtkUnstructuredGrid* grid, bool inFloat)
{
  const vtkIdType count = grid->GetNumberOfPoints();
  std::vector<Vector3> points(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    grid->GetPoint(i, points[i].data());
    for (double& x : points[i])
    {
      x = inFloat ? roundedToFloat(x) : x;
      x = std::isfinite(x) ? x : 0;
    }
  }
  std::vector<Id> sorted(count);
  std::iota(sorted.begin(), sorted.end(), Id(0));
  vtkSMPTools::Sort(sorted.begin(), sorted.end(),
    [&](Id a, Id b) { return points[a] != points[b] ? points[a] < points[b] : a < b; });
  std::vector<Id> order(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    order[sorted[i]] = static_cast<Id>(i);
  }
  return order;
}

Decomposition decomposeRange(
  vtkUnstructuredGrid* grid, vtkIdType begin, vtkIdType end, const PointNumbers& numbers)
{
  const CellTypes types(grid);
  CellCutter cutter(grid, numbers);
  cutter.Result.Tets.reserve(end - begin);
  cutter.Result.Cells.reserve(end - begin);
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    cutter.cut(cell, types[cell]);
  }
  return std::move(cutter.Result);
}

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

// Append the result of one range to those before it.
void join(Decomposition& result, Decomposition&& part, Id numberOfPoints)
{
  const Id centersBefore = static_cast<Id>(result.CenterCells.size());
  if (centersBefore > 0 && !part.CenterCells.empty())
  {
    for (auto& tet : part.Tets)
    {
      for (Id& id : tet)
      {
        id += id >= numberOfPoints ? centersBefore : 0;
      }
    }
  }
  append(result.Tets, part.Tets);
  append(result.Cells, part.Cells);
  append(result.CenterCells, part.CenterCells);
  append(result.CenterPositions, part.CenterPositions);
  result.HasCutCells = result.HasCutCells || part.HasCutCells;
  result.Report.LowDimensionalCells += part.Report.LowDimensionalCells;
  result.Report.UnsupportedCells += part.Report.UnsupportedCells;
  part = {};
}

} // namespace

std::string decompose(vtkUnstructuredGrid* grid, const Progress& progress, Decomposition& result,
  bool& stopped, const PieceOptions& piece)
{
  stopped = false;
  result = {};
  std::string wrong = checkData(grid);
  const vtkIdType cells = grid->GetNumberOfCells();
  if (!wrong.empty() || cells == 0)
  {
    return wrong;
  }
  result.FirstPoints = findCoincidentPoints(grid, piece.InFloat);
  PointNumbers numbers;
  numbers.Firsts = piece.SeparatePoints ? std::vector<Id>() : result.FirstPoints;
  if (piece.ByCoordinates && isCut(grid))
  {
    numbers.Order = orderByCoordinates(grid, piece.InFloat);
  }
  const vtkIdType ranges = std::min<vtkIdType>(64, cells / 1024 + 1);
  const vtkIdType portion = 8; // number of ranges between two reports of progress
  result.Tets = roomFor<std::array<Id, 4>>(cells);
  result.Cells = roomFor<Id>(cells);
  for (vtkIdType begin = 0; begin < ranges; begin += portion)
  {
    const vtkIdType end = std::min(begin + portion, ranges);
    std::vector<Decomposition> parts(end - begin);
    parallelFor(begin, end, 1,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType range = first; range < last; ++range)
        {
          parts[range - begin] =
            decomposeRange(grid, range * cells / ranges, (range + 1) * cells / ranges, numbers);
        }
      });
    for (Decomposition& part : parts)
    {
      join(result, std::move(part), static_cast<Id>(grid->GetNumberOfPoints()));
    }
    if (result.Tets.size() > static_cast<std::size_t>(MostTetrahedra))
    {
      return "The grid has more than " + std::to_string(MostTetrahedra) +
             " tetrahedra, which is more than can be numbered. Extract a part of it.";
    }
    if (progress && !progress(static_cast<double>(end) / static_cast<double>(ranges)))
    {
      stopped = true;
      return {};
    }
  }
  return {};
}

} // namespace tetmarch
