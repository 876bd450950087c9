// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks whether the arrays of a grid are consistent, before a value of one array is used as an
// index into another.
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
/** Indices of half-faces, including those outside, fit in 32 bits. */
constexpr vtkIdType MostTetrahedra = vtkIdType(1) << 29;

/**
 * Returns an empty string if the grid can be decomposed, or else an error with the array, the cell
 * or point, the value, and the allowed values; of several invalid cells it names the first. A valid
 * grid causes no reads out of bounds in vtkCellArray::GetCellAtId,
 * vtkUnstructuredGrid::GetFaceStream and, for cells triangulated by VTK, GetCell, and the
 * coordinates of points of 3D cells are finite. One parallel pass over the raw arrays.
 */
std::string checkGrid(vtkUnstructuredGrid* grid);

/** The same for the hexahedra of a grid with these numbers of cells and points. */
std::string checkHexahedra(vtkCellArray* cells, vtkIdType count, vtkIdType points);

/** The checks that need only the numbers of cells and points. */
std::string checkCounts(vtkIdType cells, vtkIdType points);

} // namespace tetmarch

#endif
