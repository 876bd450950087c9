// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells that a grid's ghost arrays keep from being drawn.
#ifndef TetMarchMeshHiddenCells_h
#define TetMarchMeshHiddenCells_h

#include "Mesh/TetMesh.h"
#include "Scalars/GhostArrays.h"

class vtkUnstructuredGrid;

namespace tetmarch
{

/** One bit for each tetrahedron: bit t % 32 of word t / 32. Empty if none is hidden. */
using HiddenCells = std::vector<std::uint32_t>;

/** Hidden are the tetrahedra of cells that are marked as hidden, as a duplicate (which another
 * process draws) or as refined by finer cells, and of cells with a hidden point. */
HiddenCells hiddenCells(vtkUnstructuredGrid* grid, const TetMesh& mesh);

} // namespace tetmarch

#endif
