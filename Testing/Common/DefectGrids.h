// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tetrahedra in bad order: turned over, repeated, with points that are not merged
 *
 * Tetrahedra only. Scalars go along.
 */
#ifndef tetmarch_testing_DefectGrids_h
#define tetmarch_testing_DefectGrids_h

#include "GridBuilder.h"

namespace tetmarch::testing
{
/// The first two points of every `every`-th cell change places, from cell 0 on.
Grid withReversedCells(vtkUnstructuredGrid* grid, int every);

/// Every `every`-th cell once more, after all others, its points in another order.
Grid withRepeatedCells(vtkUnstructuredGrid* grid, int every);

/// A lattice of n^3 cubes, by the order of jitteredLattice(), whose points in the middle layer of
/// x, below the middle of y, are there twice: the cells beyond use the second one. A crack without
/// width that ends inside the mesh.
Grid withCrack(vtkUnstructuredGrid* lattice, int n);
} // namespace tetmarch::testing

#endif
