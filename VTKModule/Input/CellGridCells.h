// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of a vtkCellGrid as an unstructured grid, with their fields as they are: jumps stay.
#ifndef TetMarchInputCellGridCells_h
#define TetMarchInputCellGridCells_h

#include "Caching/Fingerprint.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkUnstructuredGrid;

namespace tetmarch
{

Fingerprint versionOfCellGrid(vtkDataObject* cellGrid);

/**
 * The tetrahedra, hexahedra, wedges and pyramids, type by type in the order of their names. Each
 * has points of its own, at which shape and fields are evaluated: they are those of a linear cell,
 * or of the Lagrange cell of the highest order among its shape and fields, whose functions include
 * theirs. Pyramids have order 2 at most.
 *
 * Fields of the function space "HGRAD" become arrays of points, those that are constant in each
 * cell of all types become arrays of cells. Others ("HCURL", "HDIV") are left out. The first field
 * is the active scalars. Returns an empty string, or an error if the grid isn't sound.
 */
std::string makeCellsOfCellGrid(
  vtkDataObject* cellGrid, vtkSmartPointer<vtkUnstructuredGrid>& cells);

} // namespace tetmarch

#endif
