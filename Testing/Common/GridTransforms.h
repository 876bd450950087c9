// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The same mesh renumbered, moved, or stored in other types
 *
 * The argument is never changed; arrays that stay the same are shared with it.
 */
#ifndef tetmarch_testing_GridTransforms_h
#define tetmarch_testing_GridTransforms_h

#include "GridBuilder.h"

namespace tetmarch::testing
{
/// Points and cells in a random order, and the points within each cell too, so that about half of
/// the tetrahedra have a negative volume. Tetrahedra only. Point and cell data go along.
Grid shuffled(vtkUnstructuredGrid* grid, unsigned seed = 1);

/// Every point p at offset + scale p (double); the scalars stay.
Grid withOffsetAndScale(vtkUnstructuredGrid* grid, const Vec3& offset, double scale);

/// Points in single precision.
Grid withFloatPoints(vtkUnstructuredGrid* grid);

/// Cell connectivity in 32-bit integers.
Grid withCells32(vtkUnstructuredGrid* grid);

/// Each cell with points of its own, as programs write whose fields jump between cells.
Grid withRepeatedPoints(vtkUnstructuredGrid* grid);

/// The same, and the scalars of the second half of the cells move by up to `most` at each corner:
/// they jump between cells.
Grid withJumps(vtkUnstructuredGrid* grid, double most, unsigned seed = 1);

/// Convex hexahedra with plane faces in six tetrahedra each, with the "c" of their cell and all
/// point data. Those that a ghost array marks are left out.
Grid inTetrahedra(vtkUnstructuredGrid* hexahedra);

/// The cells of both, first those of a, with their "f" and "c"; no points are merged. No polyhedra.
Grid joined(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b);
} // namespace tetmarch::testing

#endif
