// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A grid of the cells between the centres of leaves.
#ifndef TetMarchLeavesDualGrid_h
#define TetMarchLeavesDualGrid_h

#include "Leaves/DualCells.h"

class vtkUnstructuredGrid;

namespace tetmarch
{

/** Set points, cells and arrays of points of the empty grid. */
void makeGrid(const Leaves& leaves, const DualCells& cells, vtkUnstructuredGrid* grid);

} // namespace tetmarch

#endif
