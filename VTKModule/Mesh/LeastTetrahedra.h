// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How many tetrahedra a grid becomes at least, without cutting it.
#ifndef TetMarchMeshLeastTetrahedra_h
#define TetMarchMeshLeastTetrahedra_h

#include <cstdint>

class vtkUnstructuredGrid;

namespace tetmarch
{

/** Of a cell of that type whose points are all different; 0 for types that can't be cut, too. */
int leastTetrahedraOfType(int cellType);

/**
 * A sum over the cell types. If that is above `enough`, the cells are looked at one by one and
 * those left out that name a point twice, of which less may come. What two cells in the same place
 * have in common counts for both. Any grid may be given, also one whose arrays don't fit together.
 */
std::uint64_t leastTetrahedra(vtkUnstructuredGrid* grid, std::uint64_t enough);

} // namespace tetmarch

#endif
