// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Named scalar fields on space, and their values on a grid
 *
 * All are made for the unit cube and take values in [0, 1] there, so that one transfer function
 * over [0, 1] serves every test.
 */
#ifndef tetmarch_testing_Fields_h
#define tetmarch_testing_Fields_h

#include <functional>

class vtkUnstructuredGrid;

namespace tetmarch::testing
{
using Field = std::function<double(double x, double y, double z)>;

Field constantField(double value);
/// 0.2 x + 0.3 y + 0.5 z: no gradient component vanishes and no two agree.
Field linearField();
/// 1/2 + 1/2 sin(2 pi a x) sin(2 pi a y + 1) sin(2 pi a z + 2) with a waves along an edge of the
/// cube.
Field sineField(double waves = 1.0);
/// Value noise: a hash of the seed at the points of a lattice with spacing 1/frequency, trilinear
/// in between.
Field noiseField(unsigned seed = 1, int frequency = 16);
/// Uniform noise in 0..1, another number for each point: no scalar bends more.
Field scatteredField(unsigned seed);
/// The distance from the centre of the unit cube; 1 at its corners.
Field radialField();
/// 1/2 in the middle of the cube, from 0 to 1 along the direction (of any length) in which the cube
/// is widest.
Field linearFieldAlong(double dx, double dy, double dz);
/// x y z: along the diagonal of the cube it is s^3.
Field productField();
/// The test signal of Marschner and Lobb, "An evaluation of reconstruction filters for volume
/// rendering" (1994), with their frequency 6 and amplitude 0.25; [-1, 1]^3 is the unit cube here.
Field marschnerLobbField();
/// 0 up to half of the cube along x, then 1.
Field stepField();
/// 0 and 1 by turns at the points of a lattice of n cells along each edge.
Field checkerboardField(int n);

/// Give the grid the active point scalars "f", the field at every point, and the active cell
/// scalars "c", the field at the mean of the points of every cell (both double).
void attachFields(vtkUnstructuredGrid* grid, const Field& field);
} // namespace tetmarch::testing

#endif
