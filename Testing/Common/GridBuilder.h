// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Put a small unstructured grid together, cell by cell
 *
 * Points are named by integer coordinates of a lattice, so that cells which meet there share them
 * exactly.
 */
#ifndef tetmarch_testing_GridBuilder_h
#define tetmarch_testing_GridBuilder_h

#include "Fields.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnstructuredGrid.h" // Grid is used with ->

#include <array>
#include <map>
#include <vector>

namespace tetmarch::testing
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
using Ids = std::vector<vtkIdType>;
using Vec3 = std::array<double, 3>;

class GridBuilder
{
public:
  /// Lattice point (i, j, k) lies at the origin plus (i, j, k) times the spacing, component by
  /// component.
  explicit GridBuilder(const Vec3& spacing = { 1.0, 1.0, 1.0 });
  ~GridBuilder();
  GridBuilder(const GridBuilder&) = delete;
  GridBuilder& operator=(const GridBuilder&) = delete;

  /// A new point, whatever points there are.
  vtkIdType addPoint(const Vec3& position);
  /// The one point at lattice coordinates (i, j, k).
  vtkIdType at(int i, int j, int k);
  /// The one point halfway (or, of more than two, in the mean) of other points, whatever their
  /// order.
  vtkIdType between(Ids points);

  Vec3 position(vtkIdType point) const;
  void move(vtkIdType point, const Vec3& position);

  void addCell(int vtkCellType, const Ids& points);
  void addPolyhedron(const std::vector<Ids>& faces);

  /// The grid, with the scalars of attachFields().
  Grid finish(const Field& field);

private:
  Vec3 Spacing;
  Grid Result;
  std::map<std::array<int, 3>, vtkIdType> AtLattice;
  std::map<Ids, vtkIdType> Between;
};
} // namespace tetmarch::testing

#endif
