// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The order in which blocks are drawn over each other.
#ifndef TetMarchBlocksBlockOrder_h
#define TetMarchBlocksBlockOrder_h

#include <array>
#include <cstddef>
#include <vector>

namespace tetmarch
{

/** xmin, xmax, ymin, ymax, zmin, zmax. */
using BlockBox = std::array<double, 6>;

/**
 * The indices of the boxes from back to front, as seen from (eye, 1), or, in parallel projection,
 * from the direction (towards the eye, 0). A box comes before all that can hide part of it: of two
 * disjoint boxes, the one beyond a plane between them hides nothing of the other (Fuchs, Kedem and
 * Naylor 1980). If this leaves a choice, or if boxes overlap or hide each other cyclically, the one
 * whose centre is farther away comes first.
 */
std::vector<std::size_t> backToFront(
  const std::vector<BlockBox>& boxes, const std::array<double, 4>& eye);

} // namespace tetmarch

#endif
