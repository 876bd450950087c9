// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Lattices of each linear cell type, and of all of them together
 *
 * All fill the unit cube but for the honeycombs. Their points are latticePoints(n, warp, 1): warp
 * moves them by at most warp times the spacing and so bends quadrilaterals out of their planes.
 */
#ifndef tetmarch_testing_CellTypeGrids_h
#define tetmarch_testing_CellTypeGrids_h

#include "GridBuilder.h"

namespace tetmarch::testing
{
/// n^3 hexahedra.
Grid hexLattice(int n, double warp = 0.0, const Field& field = linearField());
/// n^3 voxels.
Grid voxelLattice(int n, const Field& field = linearField());
/// 2 n^3 wedges along z.
Grid wedgeLattice(int n, double warp = 0.0, const Field& field = linearField());
/// 6 n^3 pyramids, their tips in the middle of each cube.
Grid pyramidLattice(int n, double warp = 0.0, const Field& field = linearField());
/// n^3 hexahedra given as VTK_POLYHEDRON.
Grid polyhedronLattice(int n, double warp = 0.0, const Field& field = linearField());

/// n layers of height 1/n of a honeycomb of n x n regular hexagons with sides 1/(2n): n^3 hexagonal
/// prisms, about the size of the unit cube, volume honeycombVolume(n), not convex.
Grid hexagonalPrismLattice(int n, const Field& field = linearField());
/// The same with every hexagon cut in two pentagons by a line along y: 2 n^3 pentagonal prisms.
Grid pentagonalPrismLattice(int n, const Field& field = linearField());
double honeycombVolume(int n);

/// The unit cube as a polyhedron of nine faces (corners of its split face stand on its other faces'
/// edges) beside four hexahedra of 1 x 1/2 x 1/2 in 1 <= x <= 2: five cells, volume 2.
Grid splitFacePolyhedron(const Field& field = linearField());

/// One conforming mesh of n^3 cubes that are, at random, a hexahedron, two wedges, six tetrahedra,
/// or pyramids and tetrahedra about the centre of the cube, whichever lets both cells at a face
/// have the same corners. All four types occur from n = 3 on (tested for n = 3, 4, 6).
Grid mixedCells(int n, unsigned seed = 1, double warp = 0.0, const Field& field = linearField());
} // namespace tetmarch::testing

#endif
