// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The points of a tessellation, with all arrays of the grid's points.
#ifndef TetMarchCurvedOutputPoints_h
#define TetMarchCurvedOutputPoints_h

#include "Curved/CurvedCell.h"
#include "Geometry/Vector3.h"

#include "vtkNew.h"

#include <vector>

class vtkDataArray;
class vtkIdList;
class vtkPoints;
class vtkUnstructuredGrid;

namespace tetmarch
{

class OutputPoints
{
public:
  /** Scalars of the grid's points may be null. */
  OutputPoints(vtkUnstructuredGrid* grid, vtkDataArray* scalars, vtkUnstructuredGrid* output);
  ~OutputPoints();

  /** The point for one of the grid, whose attributes it has. */
  vtkIdType copyOf(vtkIdType point);
  /** A new point: a mixture of these points of the grid. */
  vtkIdType insert(const CurvedPlace& place, vtkIdList* mixed);

  Vector3 position(vtkIdType point) const;
  double value(vtkIdType point, std::size_t component) const
  {
    return this->Values[static_cast<std::size_t>(point) * this->Components + component];
  }

private:
  vtkUnstructuredGrid* Grid;
  vtkDataArray* Scalars;
  vtkUnstructuredGrid* Output;
  std::size_t Components;
  vtkNew<vtkPoints> Points;
  std::vector<double> Values;
  std::vector<vtkIdType> Copies; // by points of the grid
};

} // namespace tetmarch

#endif
