// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The degrees of Lagrange and Bezier cells, and whether they fit their numbers of points.
#ifndef TetMarchInputHigherOrderCheck_h
#define TetMarchInputHigherOrderCheck_h

#include "Input/LinearParts.h"

#include "vtkType.h"

#include <string>

class vtkDataArray;
class vtkUnstructuredGrid;

namespace tetmarch
{

/** The arrays of such cells, attributes of the grid's cells and points; either may be null. */
struct HigherOrderArrays
{
  vtkDataArray* Degrees; // three per cell: of hexahedra and wedges along each axis
  vtkDataArray* Weights; // one per point: of Bezier cells
  vtkIdType NumberOfPoints;

  explicit HigherOrderArrays(vtkUnstructuredGrid* grid);

  /** Empty for cells of other types and for those whose number of points matches their order; else
   * an error. */
  std::string errorOf(vtkIdType cell, int type, vtkIdType points) const;

  /** Of a hexahedron or wedge without an error. A wedge of 21 points has none: { 0, 0, 0 }. */
  CellDegrees degreesOf(vtkIdType cell, int type, vtkIdType points) const;
};

} // namespace tetmarch

#endif
