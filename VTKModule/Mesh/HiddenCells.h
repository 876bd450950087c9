// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells hidden by a grid's ghost arrays.
#ifndef TetMarchMeshHiddenCells_h
#define TetMarchMeshHiddenCells_h

#include "Mesh/TetMesh.h"
#include "Scalars/GhostArrays.h"

class vtkPointSet;

namespace tetmarch
{

/** One bit for each tetrahedron: bit t % 32 of word t / 32. Empty if none is hidden. */
using HiddenCells = std::vector<std::uint32_t>;

/** The tetrahedra of cells that are marked as hidden, as a duplicate (drawn by another process) or
 * as refined by finer cells, and of cells with a hidden point. */
HiddenCells hiddenCells(vtkPointSet* grid, const TetMesh& mesh);

} // namespace tetmarch

#endif
