// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the arrays of a grid fit together, before anything reads one by way of another.
#ifndef TetMarchMeshGridCheck_h
#define TetMarchMeshGridCheck_h

#include "vtkType.h"

#include <string>

class vtkUnstructuredGrid;

namespace tetmarch
{

/** Ids of points and cells are 32 bits wide, one of which is the mark of the outside. */
constexpr vtkIdType MostPointsOrCells = vtkIdType(1) << 31;
/** The number of every half-face, those of the outside included, fits in 32 bits. */
constexpr vtkIdType MostTetrahedra = vtkIdType(1) << 29;
/** The volume of a tetrahedron of such coordinates is in the range of double precision. */
constexpr double MostCoordinate = 1e100;

/**
 * Empty if the grid can be cut, or what is wrong with it: which array, which cell or point, which
 * value and what it may be; of several cells the first. Afterwards vtkCellArray::GetCellAtId,
 * vtkUnstructuredGrid::GetFaceStream and, of cells that VTK is left to cut, GetCell read nothing
 * that isn't there, and the coordinates of points that 3D cells name are finite. One pass in
 * parallel over the raw arrays.
 */
std::string checkGrid(vtkUnstructuredGrid* grid);

/** The part of it that needs no arrays. */
std::string checkCounts(vtkIdType cells, vtkIdType points);

} // namespace tetmarch

#endif
