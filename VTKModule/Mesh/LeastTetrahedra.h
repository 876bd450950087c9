// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A lower bound for the number of tetrahedra of a grid, without cutting it.
#ifndef TetMarchMeshLeastTetrahedra_h
#define TetMarchMeshLeastTetrahedra_h

#include <cstdint>

class vtkUnstructuredGrid;

namespace tetmarch
{

/** The tetrahedra of a cell of that type whose points are all different; 0 for types that can't be
 * cut. */
int leastTetrahedraOfType(int cellType);

/**
 * A sum over the cell types. If it is above `enough`, the cells are looked at one by one, and
 * those that name a point twice, which may become fewer tetrahedra, are left out. Cells that
 * overlap count each in full. Any grid may be given, also one whose arrays don't fit together.
 */
std::uint64_t leastTetrahedra(vtkUnstructuredGrid* grid, std::uint64_t enough);

} // namespace tetmarch

#endif
