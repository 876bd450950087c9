// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells of a lattice that ghost arrays keep from being drawn.
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
 * `points` is how many the data has along each axis.
 *
 * A cell of the data is hidden if it is marked so, or one of its eight points is. Where cells of
 * the lattice are cells of the data, the same cells are hidden. Of linear values of cells a cell of
 * the lattice is hidden if any of the up to eight cells of the data is that it interpolates
 * between. Of nearest values of points it is hidden if its own point is marked so, or all of the up
 * to eight cells of the data around that are: points next to a hidden one are drawn.
 */
std::vector<std::uint32_t> hiddenLatticeCells(
  const GhostArrays& ghosts, const std::array<int, 3>& points, const LatticeCase& lies);

} // namespace tetmarch

#endif
