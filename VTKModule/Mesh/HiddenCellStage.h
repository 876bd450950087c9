// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The hidden cells of a grid, updated when the mesh or a ghost array has changed.
#ifndef TetMarchMeshHiddenCellStage_h
#define TetMarchMeshHiddenCellStage_h

#include "Caching/CachedStage.h"
#include "Mesh/HiddenCells.h"

namespace tetmarch
{

class HiddenCellStage
{
public:
  /** meshRun: the run of the mesh stage that made this mesh. Returns whether the hidden cells may
   * have changed. */
  bool update(vtkPointSet* grid, const TetMesh& mesh, std::int64_t meshRun);

  const HiddenCells& cells() const { return this->Cells; }
  /** Equal if the same cells are hidden. */
  const Fingerprint& version() const { return this->Made.input(); }
  const StageRecord& record() const { return this->Made.record(); }

private:
  HiddenCells Cells;
  CachedStage Made;
};

} // namespace tetmarch

#endif
