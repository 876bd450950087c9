// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Meshes that break the rules: slivers, folds, shared faces, cracks
 */
#ifndef tetmarch_testing_BrokenGrids_h
#define tetmarch_testing_BrokenGrids_h

#include "GridBuilder.h"

#include <functional>

namespace tetmarch::testing
{
/// The same grid, points moved; scalars stay.
Grid movedPoints(vtkUnstructuredGrid* grid, const std::function<Vec3(const Vec3&, vtkIdType)>& to);

/// The same points and scalars with other cells, all of them tetrahedra.
Grid withTets(vtkUnstructuredGrid* grid, const std::vector<Ids>& tets);
/// The corners of each cell of a grid of tetrahedra.
std::vector<Ids> tetsOf(vtkUnstructuredGrid* grid);

/// `count` tetrahedra about the edge from (0,0,0) to (0,0,1), their other corners in a circle of
/// that radius at z = 1/2.
Grid needleFan(int count, double radius, const Field& field = linearField());

/// A ring of prisms over a triangle, three tetrahedra each, whose last joins the first with two of
/// its corners exchanged: going once around turns left into right, as on a Moebius strip. The last
/// prism passes through itself.
Grid moebiusRing(int prisms, const Field& field = linearField());

/// Tetrahedra with one face in common and their tips on its two sides.
Grid tetsOnOneFace(int above, int below, const Field& field = linearField());
} // namespace tetmarch::testing

#endif
