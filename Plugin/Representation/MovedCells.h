// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells that ParaView moves to other processes, where it redistributes the data of a view.
#ifndef TetMarchMovedCells_h
#define TetMarchMovedCells_h

#include "vtkSmartPointer.h"

class vtkUnstructuredGrid;

namespace tetmarch
{

/**
 * A copy to be moved. VTK leaves out cells that are ghosts, and takes the array of ghost types away
 * from the others: what it hides is kept in another array.
 */
vtkSmartPointer<vtkUnstructuredGrid> packCells(vtkUnstructuredGrid* grid);

/**
 * A copy of what has arrived, in which the same cells and points are hidden as before. A cell that
 * several processes got is a ghost in none.
 */
vtkSmartPointer<vtkUnstructuredGrid> unpackCells(vtkUnstructuredGrid* grid);

} // namespace tetmarch

#endif
