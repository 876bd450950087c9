// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A lattice with holes wherever a noise is low, as users make such meshes: by vtkThreshold
 */
#ifndef tetmarch_testing_SwissCheese_h
#define tetmarch_testing_SwissCheese_h

#include "GridBuilder.h"

namespace tetmarch::testing
{
/// The tetrahedra of a jittered lattice of n^3 cubes at whose points a noise of that frequency is
/// at least 0.4; "f" is the noise.
Grid swissCheese(int n, int frequency);
} // namespace tetmarch::testing

#endif
