// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The unit cube in quadratic cells
 *
 * Mid-edge, mid-face and centre nodes lie in the mean of their corners, then each inner one is
 * moved by curvature/n times bendDirection(), which vanishes on the surface of the cube: the mesh
 * conforms and fills the cube whatever the curvature (0: straight edges; 0.1 is plain to see and
 * turns no cell over).
 */
#ifndef tetmarch_testing_QuadraticGrids_h
#define tetmarch_testing_QuadraticGrids_h

#include "GridBuilder.h"

namespace tetmarch::testing
{
/// 6 n^3 of VTK_QUADRATIC_TETRA.
Grid quadraticTetLattice(int n, double curvature = 0.0, const Field& field = linearField());
/// n^3 of VTK_QUADRATIC_HEXAHEDRON (20 nodes).
Grid quadraticHexLattice(int n, double curvature = 0.0, const Field& field = linearField());
/// n^3 of VTK_TRIQUADRATIC_HEXAHEDRON (27 nodes).
Grid triQuadraticHexLattice(int n, double curvature = 0.0, const Field& field = linearField());
/// 2 n^3 of VTK_QUADRATIC_WEDGE (15 nodes).
Grid quadraticWedgeLattice(int n, double curvature = 0.0, const Field& field = linearField());
/// 6 n^3 of VTK_QUADRATIC_PYRAMID (13 nodes).
Grid quadraticPyramidLattice(int n, double curvature = 0.0, const Field& field = linearField());

/// At most 1 long in each component, smooth, zero on the surface of the unit cube.
Vec3 bendDirection(const Vec3& position);
} // namespace tetmarch::testing

#endif
