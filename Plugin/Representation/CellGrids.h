// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cell grids, which older versions of VTK don't have.
#ifndef TetMarchCellGrids_h
#define TetMarchCellGrids_h

#include "vtkBoundingBox.h"

class vtkDataObject;

namespace tetmarch
{

bool isCellGrid(vtkDataObject* data);

struct CellGridNumbers
{
  long long Cells = 0;
  long long Fields = 0; // without the shape
};

/** Of data that are a cell grid. */
CellGridNumbers numbersOfCellGrid(vtkDataObject* grid);
vtkBoundingBox boundsOfCellGrid(vtkDataObject* grid);

} // namespace tetmarch

#endif
