// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Thin and flat tetrahedra in meshes that are sound otherwise
 *
 * But for the needle fan all fill the unit cube, with cubes in the order of jitteredLattice().
 */
#ifndef tetmarch_testing_SliverGrids_h
#define tetmarch_testing_SliverGrids_h

#include "LatticeGrids.h"

namespace tetmarch::testing
{
/// n layers along z (n even), every second one of them, from the second on, only squash / n high.
/// The points move at random within their layer.
Grid squashedLayers(int n, double squash, const Field& field = linearField());

/// A plain lattice some of whose points inside have moved into the plane of two opposite faces of
/// tetrahedra that use them: those are exactly flat, no other one is, and none is turned over.
/// n a power of two, so that all coordinates are exact.
Grid flatTetsInside(int n, const Field& field = linearField());
/// The same with points that have moved into the sides x = 0 and x = 1: the flat tetrahedra lie in
/// the surface of the cube.
Grid flatTetsOnBoundary(int n, const Field& field = linearField());

/// A plain lattice some of whose points inside lie exactly where a neighbour lies: edges of no
/// length, with flat tetrahedra about them. n a power of two.
Grid edgesWithoutLength(int n, const Field& field = linearField());
/// The same, but the cells name the neighbour instead, once more where they had it already: cells
/// with repeated points. Then cells with three and with four equal points, and with two pairs.
Grid cellsWithRepeatedPoints(int n, const Field& field = linearField());

/// Tetrahedra round the edge from (0, 0, -height/2) to (0, 0, height/2), every one between two
/// neighbouring points of the unit circle: a double pyramid.
Grid needleFan(int tets, double height = 1.0, const Field& field = linearField());
} // namespace tetmarch::testing

#endif
