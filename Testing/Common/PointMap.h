// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The same cells and scalars with their points elsewhere
 */
#ifndef tetmarch_testing_PointMap_h
#define tetmarch_testing_PointMap_h

#include "GridBuilder.h"

#include <functional>

namespace tetmarch::testing
{
/// The new position of point number `id`, which is at p.
using PointMap = std::function<Vec3(const Vec3& p, vtkIdType id)>;

/// Every point moved, in double; cells and scalars are shared with the argument.
Grid mapped(vtkUnstructuredGrid* grid, const PointMap& map);

/// Every coordinate rounded to a multiple of the step (a power of two, so that sums of such
/// coordinates are exact).
Grid rounded(vtkUnstructuredGrid* grid, double step);
} // namespace tetmarch::testing

#endif
