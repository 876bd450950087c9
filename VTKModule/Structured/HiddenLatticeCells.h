// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells of a lattice hidden by ghost arrays.
#ifndef TetMarchStructuredHiddenLatticeCells_h
#define TetMarchStructuredHiddenLatticeCells_h

#include "Scalars/GhostArrays.h"
#include "Structured/LatticeBuilder.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/**
 * One bit for each cell of the lattice: bit c % 32 of word c / 32. Empty if none is hidden.
 * `points` is the number of the data's points along each axis.
 *
 * A cell of the data is hidden if it or one of its eight points is marked as hidden. If cells of
 * the lattice are cells of the data, the same cells are hidden. With linear cell values, a cell of
 * the lattice is hidden if any of the up to eight cells of the data between which it interpolates
 * is hidden. With nearest point values, it is hidden if its point is marked, or all of the up to
 * eight surrounding cells of the data are hidden: points next to a hidden cell are drawn.
 */
std::vector<std::uint32_t> hiddenLatticeCells(
  const GhostArrays& ghosts, const std::array<int, 3>& points, const LatticeCase& lies);

} // namespace tetmarch

#endif
