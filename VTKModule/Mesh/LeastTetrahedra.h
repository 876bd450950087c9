// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A lower bound for the number of tetrahedra of a grid, without cutting it.
#ifndef TetMarchMeshLeastTetrahedra_h
#define TetMarchMeshLeastTetrahedra_h

#include <cstdint>

class vtkUnstructuredGrid;

namespace tetmarch
{

/** The minimum number of tetrahedra of a cell of this type with distinct points; 0 for types that
 * can't be decomposed. */
int leastTetrahedraOfType(int cellType);

/**
 * The sum over the cell types. If it is above `enough`, the cells are checked one by one, and those
 * that contain a point twice, which may become fewer tetrahedra, are left out. Overlapping cells
 * count in full. The grid may be invalid.
 */
std::uint64_t leastTetrahedra(vtkUnstructuredGrid* grid, std::uint64_t enough);

} // namespace tetmarch

#endif
