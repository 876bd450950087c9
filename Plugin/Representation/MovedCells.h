// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells that ParaView moves to other processes when it redistributes the data of a view.
#ifndef TetMarchMovedCells_h
#define TetMarchMovedCells_h

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace tetmarch
{

/**
 * A copy to be moved. VTK leaves out ghost cells, and removes the array of ghost types from the
 * others: therefore hidden cells are stored in another array.
 */
vtkSmartPointer<vtkUnstructuredGrid> packCells(vtkUnstructuredGrid* grid);

/**
 * A copy of the received cells, with the original hidden cells and points. A cell that several
 * processes received is a ghost in none.
 */
vtkSmartPointer<vtkUnstructuredGrid> unpackCells(vtkUnstructuredGrid* grid);

/**
 * A cached result of one of these functions. It is updated only for another or a modified grid.
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
