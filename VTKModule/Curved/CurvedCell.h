// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// One curved cell, evaluated by its own shape functions.
#ifndef TetMarchCurvedCurvedCell_h
#define TetMarchCurvedCurvedCell_h

#include "Curved/CurvedShape.h"
#include "Geometry/Vector3.h"

#include "vtkGenericCell.h"
#include "vtkNew.h"

#include <vector>

class vtkDataArray;
class vtkUnstructuredGrid;

namespace tetmarch
{

/** A place in a cell: the share of each of its points, where it is, and the scalars there. */
struct CurvedPlace
{
  std::vector<double> Weights;
  Vector3 Position;
  std::vector<double> Values;
};

/** Places are given by the parametric coordinates of CurvedShape. */
class CurvedCell
{
public:
  /** Scalars of points may be null. */
  CurvedCell(vtkUnstructuredGrid* grid, vtkDataArray* scalars);

  void read(vtkIdType cell, const CurvedShape& shape);

  vtkIdList* points() { return this->Cell->GetPointIds(); }
  void evaluate(const Vector3& at, CurvedPlace& place);

private:
  vtkUnstructuredGrid* Grid;
  vtkDataArray* Scalars;
  vtkNew<vtkGenericCell> Cell;
  std::vector<double> PointValues; // all components of a point, then the next point
  bool IsPyramid = false;
  bool IsCollapsed = false; // a pyramid whose apex is a face of the unit cube to VTK
};

} // namespace tetmarch

#endif
