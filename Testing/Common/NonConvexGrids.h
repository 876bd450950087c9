// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Meshes that a ray may leave and enter again, as parts of a lattice
 */
#ifndef tetmarch_testing_NonConvexGrids_h
#define tetmarch_testing_NonConvexGrids_h

#include "LatticeGrids.h"

namespace tetmarch::testing
{
/// The unit cube without the cubes of the box [holeBegin(n)/n, holeEnd(n)/n]^3 in its middle: a
/// closed cavity.
Grid latticeWithHole(
  int n, double jitter = 0.15, unsigned seed = 1, const Field& field = linearField());
/// The middle third: the hole and the tunnel take the cubes holeBegin(n) <= index < holeEnd(n).
int holeBegin(int n);
int holeEnd(int n);

/// The unit cube with the same cross-section bored through it along z.
Grid latticeWithTunnel(
  int n, double jitter = 0.15, unsigned seed = 1, const Field& field = linearField());

/// The unit cube without its quarter x >= 1/2, y >= 1/2 (n even).
Grid lShape(int n, double jitter = 0.15, unsigned seed = 1, const Field& field = linearField());

/// The unit cube, and a second one of half its size that begins at (1.25, 0.25, 0.25); they share
/// no point.
Grid twoComponents(
  int n, double jitter = 0.15, unsigned seed = 1, const Field& field = linearField());

/// The cubes whose centre's distance from the middle, in units of half the edge over the bands, has
/// an even whole part: ball, gap, shell, gap, ... and corners. Shells may touch in edges and
/// vertices.
Grid nestedShells(int n, int bands = 4, double jitter = 0.15, unsigned seed = 1,
  const Field& field = linearField());
} // namespace tetmarch::testing

#endif
