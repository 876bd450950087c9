// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How far a straight edge may be from the curved cell in its place.
#ifndef TetMarchCurvedCurvedTolerance_h
#define TetMarchCurvedCurvedTolerance_h

#include "Curved/CellPieces.h"
#include "Curved/CurvedCell.h"
#include "Curved/CurvedDeparture.h"
#include "Curved/OutputPoints.h"

#include <vector>

class vtkDataArray;
class vtkUnstructuredGrid;

namespace tetmarch
{

struct CurvedTolerance
{
  double Distance;            // in units of coordinates
  vtkDataArray* Scalars;      // of points, or null
  std::vector<double> Values; // for each component of the scalars
};

/** These parts of the grid's diagonal, and of the range of each component of the scalars. */
CurvedTolerance toleranceOf(
  vtkUnstructuredGrid* grid, vtkDataArray* scalars, double partOfDiagonal, double partOfRange);

/** Whether an edge of a cell leaves a tolerance at a quarter, a half or three quarters of it. An
 * edge below 1/64 of a cell's does not. If it does not, `departure`, unless null, becomes that of
 * the one of these three points that is farthest off. `place` is overwritten. */
bool leavesTolerance(const CurvedTolerance& tolerance, const PieceCorner& a, const PieceCorner& b,
  const OutputPoints& points, CurvedCell& cell, CurvedPlace& place, EdgeDeparture* departure);

} // namespace tetmarch

#endif
