// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The unit cube as n x n x n cubes of six tetrahedra
 */
#ifndef tetmarch_testing_LatticeGrids_h
#define tetmarch_testing_LatticeGrids_h

#include "GridBuilder.h"

#include <functional>
#include <random>

namespace tetmarch::testing
{
/// Uniform in [0, 1) from the raw output of the generator: the distributions of the standard
/// library differ between platforms.
double uniform(std::mt19937& generator);

/// The (n+1)^3 points of a lattice in the unit cube, x fastest, three doubles each. Every
/// coordinate moves by at most jitter times the spacing, those on the surface of the cube only
/// along it; pinned points (empty: none) stay. Below jitter = 1/6 no tetrahedron can turn over,
/// since the edge matrix stays diagonally dominant.
std::vector<double> latticePoints(
  int n, double jitter, unsigned seed, const std::vector<bool>& pinned = {});

/// 6 n^3 tetrahedra of positive volume that fill the unit cube, conforming (Kuhn's subdivision).
/// n = 30, 60, 100 give 162 thousand, 1.3 and 6 million.
Grid jitteredLattice(
  int n, double jitter = 0.15, unsigned seed = 1, const Field& field = linearField());

using CubeFilter = std::function<bool(int i, int j, int k)>;
/// The same of only some of the cubes, without the points that none of them uses. Points on the
/// surface of what was taken away are not jittered: that surface is made of exact faces of cubes.
Grid maskedLattice(int n, double jitter, unsigned seed, const Field& field, const CubeFilter& keep);
} // namespace tetmarch::testing

#endif
