// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which cells are hidden, looked at anew when the mesh or a ghost array changed.
#ifndef TetMarchMeshHiddenCellStage_h
#define TetMarchMeshHiddenCellStage_h

#include "Caching/MadeFrom.h"
#include "Mesh/HiddenCells.h"

namespace tetmarch
{

class HiddenCellStage
{
public:
  /** Of the run of the mesh stage that made this mesh of the grid. Returns whether the cells may be
   * others than before. */
  bool update(vtkUnstructuredGrid* grid, const TetMesh& mesh, std::int64_t meshRun);

  const HiddenCells& cells() const { return this->Cells; }
  /** Equal if no other cells are hidden. */
  const Fingerprint& version() const { return this->Made.input(); }
  const StageRecord& record() const { return this->Made.record(); }

private:
  HiddenCells Cells;
  MadeFrom Made;
};

} // namespace tetmarch

#endif
