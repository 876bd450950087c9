// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Meshes that a ray enters over and over: ring, spiral, comb, stack of sheets
 *
 * Made of cubes of six tetrahedra, conforming.
 */
#ifndef tetmarch_testing_ReentrantGrids_h
#define tetmarch_testing_ReentrantGrids_h

#include "GridBuilder.h"

namespace tetmarch::testing
{
/// A ring about the z axis of radius 1 with a round cross-section of radius 0.35: segments times
/// across^2 cubes.
Grid torus(int segments, int across, const Field& field = linearField());

/// A band about the z axis, of height 0.3 and thickness 0.08, whose middle moves outwards by 0.2 a
/// turn, from radius 0.2 on: segments times 2 x 2 cubes.
Grid spiral(double turns, int segments, const Field& field = linearField());

/// A bar of 2 teeth - 1 cubes of edges 1/1000, 1/8, 1/8 along x from the origin, and a cube on top
/// (along z) of the first and every second one further.
Grid comb(int teeth, const Field& field = linearField());

/// Sheets of n x n x 1 cubes over the unit square, apart by the gap, together of height 1.
Grid sheets(int count, int n, double gap, const Field& field = linearField());
} // namespace tetmarch::testing

#endif
