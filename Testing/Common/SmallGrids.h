// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Grids of a few cells, and grids that are no volume at all
 */
#ifndef tetmarch_testing_SmallGrids_h
#define tetmarch_testing_SmallGrids_h

#include "GridBuilder.h"

namespace tetmarch::testing
{
/// (0,0,0) (1,0,0) (0,1,0) (0,0,1): volume 1/6.
Grid singleTet(const Field& field = linearField());
/// singleTet() and the tetrahedron on its slanted face with the tip (1,1,1): volume 1/2.
Grid twoTetsSharingFace(const Field& field = linearField());
/// singleTet() and its mirror image by (x, y, z) -> (-x, -y, z), which share the edge along z.
Grid twoTetsSharingEdge(const Field& field = linearField());
/// singleTet() and its image by p -> -p, which share the origin.
Grid twoTetsSharingVertex(const Field& field = linearField());

/// No points, no cells, no arrays.
Grid emptyGrid();
/// A triangle, a quadrilateral, a line and a vertex on the unit square: nothing to render.
Grid triangleAndLineGrid(const Field& field = linearField());
/// 6 n^3 tetrahedra of a plain lattice, then triangles on its side z = 0, a line and a vertex.
Grid mixedDimensions(int n, const Field& field = linearField());

/// Tetrahedra that no mesh should have: in this order a sound one, the same once more in another
/// order of its points, one with a repeated point, a flat one, and a third one on a face of the
/// first two.
Grid defectiveTets(const Field& field = linearField());
} // namespace tetmarch::testing

#endif
