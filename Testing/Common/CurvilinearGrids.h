// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Curvilinear grids: the lattice of the unit cube, moved
 */
#ifndef tetmarch_testing_CurvilinearGrids_h
#define tetmarch_testing_CurvilinearGrids_h

#include "GridBuilder.h"

#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <vector>

class vtkStructuredGrid;

namespace tetmarch::testing
{
/// Where a point of the unit cube goes.
using Movement = std::function<Vec3(const Vec3&)>;

/// That many cells along i, j and k; scalars "f" of the points, by their place, and "c" of the
/// cells, by that of their lowest point.
vtkSmartPointer<vtkStructuredGrid> curvilinearGrid(
  const std::array<int, 3>& cells, const Movement& movement, const Field& field = sineField());

struct NamedMovement
{
  const char* Name;
  Movement Move;
  bool Computed;       // cells need not be stored
  bool Joined = false; // sides of the grid meet
};

/// Within or around the unit cube.
const std::vector<NamedMovement>& everyMovement();
} // namespace tetmarch::testing

#endif
