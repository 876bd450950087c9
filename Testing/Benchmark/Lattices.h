// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Datasets that are made of the unit cube, cut into tetrahedra
 */
#ifndef tetmarch_bench_Lattices_h
#define tetmarch_bench_Lattices_h

#include "Datasets.h"

namespace tetmarch::bench
{
bool isLattice(const std::string& name);
/// Of a name that isLattice() knows.
Dataset makeLattice(const std::string& name);
} // namespace tetmarch::bench

#endif
