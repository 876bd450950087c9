// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The corners of leaves, and the leaves around each of them.
#ifndef TetMarchLeavesLeafCorners_h
#define TetMarchLeavesLeafCorners_h

#include "Leaves/Leaves.h"

namespace tetmarch
{

constexpr int NoLeaf = -1;

struct LeafCorner
{
  LeafPlace At{};
  /** The leaf in each octant: bit a of its number is set on the high side of axis a. A leaf with
   * the corner inside one of its faces or edges is in two or four of them. */
  std::array<int, 8> Around{};
};

/** All corners, each once, in the order of z, y, x. */
std::vector<LeafCorner> cornersOf(const std::vector<Leaf>& leaves);

} // namespace tetmarch

#endif
