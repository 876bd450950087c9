// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Curved cells in tetrahedra that are as small as a tolerance asks for.
#ifndef TetMarchCurvedTessellation_h
#define TetMarchCurvedTessellation_h

#include "Curved/CurvedTolerance.h"

#include <functional>
#include <string>

class vtkUnstructuredGrid;

namespace tetmarch
{

/**
 * Each cell begins as tetrahedra between its corners, in its parametric coordinates. An edge that
 * leaves a tolerance, at a quarter, a half or three quarters of it, is to be halved; a tetrahedron
 * with such an edge is halved at its longest edge, in all cells that have this one, until no such
 * edge is left.
 *
 * For quadratic functions an edge's error is greatest in its middle, so all edges keep the
 * tolerance; and that within a tetrahedron is at most 1.5 times the greatest one of its edges.
 *
 * Other cells are passed on, those of less than three dimensions are left out. The progress (0 to
 * 1) returns whether to go on; where it does not, the output is unspecified. The grid must have
 * passed checkGrid(). Returns an empty string, or an error.
 *
 * The departure is the greatest one of the tetrahedra.
 *
 * M.-C. Rivara, Algorithms for refining triangular grids suitable for adaptive and multigrid
 * techniques, 1984.
 */
std::string tessellate(vtkUnstructuredGrid* grid, const CurvedTolerance& tolerance,
  const std::function<bool(double)>& progress, vtkUnstructuredGrid* output,
  CurvedDeparture* departure = nullptr);

} // namespace tetmarch

#endif
