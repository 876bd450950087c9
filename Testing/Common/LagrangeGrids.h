// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The unit cube in cells of any degree, as programs of finite elements write them
 *
 * Each inner point is moved by curvature/n times bendDirection() (QuadraticGrids.h).
 */
#ifndef tetmarch_testing_LagrangeGrids_h
#define tetmarch_testing_LagrangeGrids_h

#include "GridBuilder.h"

namespace tetmarch::testing
{
/// n^3 VTK_LAGRANGE_HEXAHEDRON, 2 n^3 VTK_LAGRANGE_WEDGE or 6 n^3 VTK_LAGRANGE_TETRAHEDRON, of
/// these degrees along the axes; tetrahedra have one degree, wedges have one along x and y. Degrees
/// that are not all equal are an array of the grid.
Grid lagrangeLattice(int type, int n, const std::array<int, 3>& degrees, double curvature = 0.0,
  const Field& field = linearField());

/// n^3 patches of parts^3 hexahedra each. Each patch has points of its own, x first, in the way of
/// deal.II's DataOut and of MFEM's ParaViewDataCollection.
Grid patchLattice(int n, int parts, double curvature = 0.0, const Field& field = linearField());
} // namespace tetmarch::testing

#endif
