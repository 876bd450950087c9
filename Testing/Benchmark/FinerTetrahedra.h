// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A coarse mesh as a larger one of the same shape
 */
#ifndef tetmarch_bench_FinerTetrahedra_h
#define tetmarch_bench_FinerTetrahedra_h

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace tetmarch::bench
{
/// The cells of a grid cut into tetrahedra, and each of these into eight by the midpoints of its
/// edges; without arrays.
vtkSmartPointer<vtkUnstructuredGrid> finerTetrahedra(vtkUnstructuredGrid* grid);
} // namespace tetmarch::bench

#endif
