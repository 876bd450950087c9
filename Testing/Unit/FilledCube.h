// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tetrahedra that fill the unit cube
 */
#ifndef tetmarch_testing_FilledCube_h
#define tetmarch_testing_FilledCube_h

#include "Geometry/Vector3.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace tetmarch::testing
{
/// The points of a cell, which must be a tetrahedron.
inline std::array<vtkIdType, 4> tetrahedron(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  grid->GetCells()->GetCellAtId(cell, ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 4);
  return { { ids->GetId(0), ids->GetId(1), ids->GetId(2), ids->GetId(3) } };
}

inline Vector3 pointOf(vtkUnstructuredGrid* grid, vtkIdType id)
{
  Vector3 point;
  grid->GetPoint(id, point.data());
  return point;
}

/// Each face is of two tetrahedra, or in the surface of the cube; the volumes add up to its own.
/// Points at one place count as one.
inline void expectFillsTheCube(vtkUnstructuredGrid* grid)
{
  std::map<Vector3, vtkIdType> places;
  std::map<std::array<vtkIdType, 3>, int> faces;
  double volume = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    std::array<vtkIdType, 4> tet = tetrahedron(grid, cell);
    const Vector3 first = pointOf(grid, tet[0]);
    const double sixfold = dot(cross(pointOf(grid, tet[1]) - first, pointOf(grid, tet[2]) - first),
      pointOf(grid, tet[3]) - first);
    EXPECT_GT(sixfold, 0) << "cell " << cell;
    volume += sixfold / 6;
    for (vtkIdType& point : tet)
    {
      point = places.try_emplace(pointOf(grid, point), point).first->second;
    }
    std::sort(tet.begin(), tet.end());
    for (int left = 0; left < 4; ++left)
    {
      std::array<vtkIdType, 3> face;
      std::copy_if(
        tet.begin(), tet.end(), face.begin(), [&](vtkIdType id) { return id != tet[left]; });
      ++faces[face];
    }
  }
  EXPECT_NEAR(volume, 1, 1e-9);
  for (const auto& [face, count] : faces)
  {
    bool isInSurface = false;
    for (int k = 0; k < 3; ++k)
    {
      for (const double side : { 0.0, 1.0 })
      {
        isInSurface |= std::all_of(face.begin(), face.end(),
          [&](vtkIdType id) { return std::abs(pointOf(grid, id)[k] - side) < 1e-9; });
      }
    }
    ASSERT_EQ(count, isInSurface ? 1 : 2);
  }
}

} // namespace tetmarch::testing

#endif
