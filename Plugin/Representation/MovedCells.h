// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells that ParaView moves to other processes, where it redistributes the data of a view.
#ifndef TetMarchMovedCells_h
#define TetMarchMovedCells_h

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

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

/**
 * What one of these makes of a grid. It is made again only of another grid, or of a modified one.
 */
class MadeGrid
{
public:
  using Function = vtkSmartPointer<vtkUnstructuredGrid>(vtkUnstructuredGrid*);

  explicit MadeGrid(Function* make)
    : Make(make)
  {
  }
  vtkUnstructuredGrid* of(vtkUnstructuredGrid* grid);

private:
  Function* Make;
  vtkSmartPointer<vtkUnstructuredGrid> From;
  vtkMTimeType Time = 0;
  vtkSmartPointer<vtkUnstructuredGrid> Made;
};

} // namespace tetmarch

#endif
