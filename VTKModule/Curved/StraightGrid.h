// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A grid without curved cells, which mappers draw in place of one that has some.
#ifndef TetMarchCurvedStraightGrid_h
#define TetMarchCurvedStraightGrid_h

#include "Curved/CurvedDeparture.h"
#include "Parallel/Progress.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <vector>

namespace tetmarch
{

struct CurvedOptions
{
  double Tolerance = 0; // a part of the grid's diagonal, and of the range of scalars of points
  bool MeasuresDeparture = false; // which takes a sixth of the time more
};

struct StraightGrid
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid; // null: none was made
  vtkSmartPointer<vtkDataArray> Scalars;
  std::vector<vtkIdType> Cells; // for each new cell the id of the given cell that it comes from
  CurvedDeparture Departure;
  bool HasDeparture = false; // it was measured
  bool Stopped = false;      // by the progress: there is no grid
};

/**
 * Cuts the curved cells of a grid (tessellate()) within a tolerance. It keeps no arrays but the
 * scalars and the ghosts of cells; a cell with a hidden point becomes a hidden cell. It makes no
 * grid if there are no curved cells. The grid must have passed checkGrid(), the scalars
 * checkScalars(). Returns an empty string, or an error.
 */
std::string straighten(vtkUnstructuredGrid* grid, vtkDataArray* scalars, bool ofCells,
  const CurvedOptions& options, const Progress& progress, StraightGrid& straight);

} // namespace tetmarch

#endif
