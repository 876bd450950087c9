// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Parts of a mesh: with holes, ragged, thin, as users' meshes are
 */
#ifndef tetmarch_bench_KeptCells_h
#define tetmarch_bench_KeptCells_h

#include "vtkIdList.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <functional>

namespace tetmarch::bench
{
/// Whether a cell with these points is kept.
using IsKept = std::function<bool(vtkIdList* points)>;

vtkSmartPointer<vtkUnstructuredGrid> keepCells(vtkUnstructuredGrid* grid, const IsKept& isKept);

/// The mean of the points.
std::array<double, 3> centerOf(vtkUnstructuredGrid* grid, vtkIdList* points);
} // namespace tetmarch::bench

#endif
