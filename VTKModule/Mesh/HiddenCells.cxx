// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/HiddenCells.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

// Whether some point of each cell is hidden.
std::vector<bool> findCellsOfHiddenPoints(vtkPointSet* grid, vtkUnsignedCharArray* points)
{
  std::vector<bool> found(static_cast<std::size_t>(grid->GetNumberOfCells()));
  vtkNew<vtkIdList> corners;
  for (std::size_t cell = 0; cell < found.size(); ++cell)
  {
    grid->GetCellPoints(static_cast<vtkIdType>(cell), corners);
    found[cell] = std::any_of(corners->begin(), corners->end(),
      [points](vtkIdType p) { return (points->GetValue(p) & HidingPoint) != 0; });
  }
  return found;
}

} // namespace

HiddenCells hiddenCells(vtkPointSet* grid, const TetMesh& mesh)
{
  const GhostArrays ghosts = ghostArraysOf(grid);
  const bool byCells = hasAny(ghosts.OfCells, HidingCell);
  std::vector<bool> byPoints;
  if (hasAny(ghosts.OfPoints, HidingPoint))
  {
    byPoints = findCellsOfHiddenPoints(grid, ghosts.OfPoints);
  }
  HiddenCells hidden((mesh.TetCells.size() + 31) / 32, 0u);
  bool any = false;
  for (std::size_t t = 0; (byCells || !byPoints.empty()) && t < mesh.TetCells.size(); ++t)
  {
    const Id cell = mesh.TetCells[t];
    if ((byCells && (ghosts.OfCells->GetValue(cell) & HidingCell) != 0) ||
        (!byPoints.empty() && byPoints[cell]))
    {
      hidden[t / 32] |= 1u << t % 32;
      any = true;
    }
  }
  return any ? hidden : HiddenCells();
}

} // namespace tetmarch
