// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Any set of unit cubes of a lattice, each as six tetrahedra, put anywhere
 */
#ifndef tetmarch_testing_CubesAsTets_h
#define tetmarch_testing_CubesAsTets_h

#include "GridBuilder.h"

#include <functional>
#include <vector>

namespace tetmarch::testing
{
using Cube = std::array<int, 3>;
using Placement = std::function<Vec3(const Cube& corner)>;

/// Cubes given by their lowest corner; neighbours share their points and conform (Kuhn's
/// subdivision). `name` tells which corners are the same point, `place` where a point lies.
Grid cubesAsTets(
  const std::vector<Cube>& cubes, const Field& field, const Placement& place,
  const std::function<Cube(const Cube& corner)>& name = [](const Cube& corner) { return corner; });

/// 1000 cubes, every second one on a bar of 1999 x 1 x 1: 1 <= y <= 2 above 0 <= y <= 1. A ray
/// along x through the teeth comes in 1000 times. About 18 thousand tetrahedra in a unit length.
Grid comb(int teeth, const Field& field = linearField());

/// A ring of `segments` x 3 x 3 cubes bent to a torus of radii 1 and 0.4.
Grid torus(int segments, const Field& field = linearField());

/// Slabs one cell thick with a gap between them, stacked along z: `slabs` x n x n cubes.
Grid sheets(int slabs, int n, double gap, const Field& field = linearField());

/// Cubes along a square spiral in the plane, one cube of gap between its turns.
Grid spiral(int turns, const Field& field = linearField());
} // namespace tetmarch::testing

#endif
