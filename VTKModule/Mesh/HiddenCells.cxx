// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/HiddenCells.h"

#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"

namespace tetmarch
{

HiddenCells hiddenCells(vtkPointSet* grid, const TetMesh& mesh)
{
  const GhostArrays ghosts = ghostArraysOf(grid);
  const bool byCells = hasAny(ghosts.OfCells, HidingCell);
  std::vector<bool> byPoints;
  if (hasAny(ghosts.OfPoints, HidingPoint))
  {
    byPoints = cellsOfHiddenPoints(grid, ghosts.OfPoints);
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
