// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The points of a tessellation, with all arrays of the grid's points.
#ifndef TetMarchCurvedOutputPoints_h
#define TetMarchCurvedOutputPoints_h

#include "Curved/CellPieces.h"
#include "Curved/CurvedCell.h"
#include "Geometry/Vector3.h"

#include "vtkNew.h"

#include <map>
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

  /** The point for one of the grid, whose attributes it has. Its place is that of the first point
   * of the grid with equal coordinates. */
  PiecePoint copyOf(vtkIdType point);
  /** A new point, a mixture of these points of the grid, at a place of its own. */
  PiecePoint insert(const CurvedPlace& place, vtkIdList* mixed);
  /** The same at the place of another point. */
  PiecePoint insertAt(std::uint32_t other, const CurvedPlace& place, vtkIdList* mixed);
  PiecePoint point(vtkIdType id) const
  {
    const auto point = static_cast<std::size_t>(id);
    return { static_cast<std::uint32_t>(id), this->Places[point] };
  }
  /** Whether points of the grid share a place. */
  bool isShared() const { return this->Shared; }

  Vector3 position(vtkIdType point) const;
  double value(vtkIdType point, std::size_t component) const
  {
    return this->Values[static_cast<std::size_t>(point) * this->Components + component];
  }
  /** Of all components as a vector. */
  double magnitude(vtkIdType point) const;

private:
  std::uint32_t firstAt(Vector3 position);

  vtkUnstructuredGrid* Grid;
  vtkDataArray* Scalars;
  vtkUnstructuredGrid* Output;
  std::size_t Components;
  vtkNew<vtkPoints> Points;
  std::vector<double> Values;
  std::vector<std::uint32_t> Places;
  std::vector<vtkIdType> Copies;                  // by points of the grid
  std::map<Vector3, std::uint32_t> FirstOfCopies; // by coordinates
  bool Shared = false;
};

} // namespace tetmarch

#endif
