// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of a tessellation, with all arrays of the grid's cells.
#ifndef TetMarchCurvedOutputCells_h
#define TetMarchCurvedOutputCells_h

#include "Curved/CellPieces.h"
#include "Curved/OutputPoints.h"

#include "vtkNew.h"
#include "vtkType.h"

class vtkIdTypeArray;
class vtkUnstructuredGrid;

namespace tetmarch
{

/** The name of an array of a tessellation: for each cell the id of the given cell that it comes
 * from. */
constexpr const char* OriginalCells = "vtkOriginalCellIds";

class OutputCells
{
public:
  OutputCells(vtkUnstructuredGrid* grid, OutputPoints& points, vtkUnstructuredGrid* output);
  ~OutputCells();

  /** A cell of the grid as it is. */
  void pass(vtkIdType cell);
  /** A piece of one. */
  void insert(vtkIdType cell, const Piece& piece);
  /** Call this after the last one. */
  void finish();

private:
  vtkUnstructuredGrid* Grid;
  OutputPoints& Points;
  vtkUnstructuredGrid* Output;
  vtkNew<vtkIdTypeArray> Origins;
};

} // namespace tetmarch

#endif
