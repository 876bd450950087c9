// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/HiddenCellStage.h"

#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"

namespace tetmarch
{

bool HiddenCellStage::update(vtkPointSet* grid, const TetMesh& mesh, std::int64_t meshRun)
{
  const GhostArrays ghosts = ghostArraysOf(grid);
  Fingerprint input;
  if (ghosts.OfCells || ghosts.OfPoints)
  {
    input.push_back(static_cast<std::uintptr_t>(meshRun));
    add(input, ghosts.OfCells);
    add(input, ghosts.OfPoints);
  }
  const bool changed = input != this->version();
  this->Made.update(
    input, [this] { this->Cells = {}; }, [&] { this->Cells = hiddenCells(grid, mesh); });
  return changed;
}

} // namespace tetmarch
