// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the arrays of a grid fit together. It is checked before anything uses a value of one
// array as an index into another.
#ifndef TetMarchInputGridCheck_h
#define TetMarchInputGridCheck_h

#include "vtkType.h"

#include <string>

class vtkCellArray;
class vtkUnstructuredGrid;

namespace tetmarch
{

/** Ids of points and cells are 32 bits wide; one bit marks the outside. */
constexpr vtkIdType MostPointsOrCells = vtkIdType(1) << 31;
/** The number of every half-face, those of the outside included, fits in 32 bits. */
constexpr vtkIdType MostTetrahedra = vtkIdType(1) << 29;

/**
 * Returns an empty string if the grid can be cut, or else what is wrong with it: which array,
 * which cell or point, which value, and which values are allowed; of several bad cells it names the
 * first. A sound grid has no reads out of bounds in vtkCellArray::GetCellAtId,
 * vtkUnstructuredGrid::GetFaceStream and, of cells that VTK cuts, GetCell, and the coordinates of
 * points that 3D cells name are finite. One pass in parallel over the raw arrays.
 */
std::string checkGrid(vtkUnstructuredGrid* grid);

/** The same of hexahedra of a grid of that many cells and points, which lists them all. */
std::string checkHexahedra(vtkCellArray* cells, vtkIdType count, vtkIdType points);

/** The checks that need only the numbers of cells and points. */
std::string checkCounts(vtkIdType cells, vtkIdType points);

} // namespace tetmarch

#endif
