// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files that tests and pictures of the window are made of. The paths are returned.
 */
#ifndef tetmarch_WriteGrids_h
#define tetmarch_WriteGrids_h

#include <QString>

namespace tetmarch
{

/// An unstructured grid of so many voxels along each axis, with waves as its scalars.
QString WriteLattice(const QString& path, int cells);

/// An unstructured grid of 8 quadratic hexahedra with bent edges; the scalar is the distance from
/// the centre.
QString WriteCurvedCells(const QString& path);

/// A unit voxel at three time steps. Its ramp along x ends at 1, then at 2, then at 3.
QString WriteSteps(const QString& path);

} // namespace tetmarch

#endif
