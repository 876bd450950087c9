// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks of cells in which nothing is seen, and how far a ray may leap from each (distance maps:
// Deakin and Knackstedt, "Efficient ray casting of volumetric images using distance maps for empty
// space skipping", 2019).
#ifndef TetMarchStructuredEmptySpace_h
#define TetMarchStructuredEmptySpace_h

#include "Optics/IntegralTable.h"
#include "Structured/Lattice.h"
#include "Structured/StoredValues.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/** Cells along each side of a block. */
constexpr int BlockShift = 2;
constexpr int BlockSide = 1 << BlockShift;

/** What the cells of each block can show: i fastest. */
struct BlockRanges
{
  std::array<int, 3> Blocks{}; // along each axis
  std::vector<std::array<float, 2>>
    Scalars;                         // least and greatest finite stored scalar of all values
                                     // that cells of the block read; {1, 0} if there is none
  std::vector<std::uint8_t> Undrawn; // 1: some value is UndrawnScalar; empty: no value is anywhere
};

BlockRanges findBlockRanges(const Lattice& lattice, const StoredValues& values);

/**
 * For each block 0 if something may be seen of it, else the chessboard distance, in blocks, to the
 * nearest one of which something may be seen: at least 1, at most 255. A block with distance d is
 * the middle of a cube of 2 d - 1 blocks in which nothing is seen.
 */
struct BlockDistances
{
  std::array<int, 3> Blocks{};
  std::vector<std::uint8_t> Distances;
  double EmptyShare = 0; // of the blocks, 0..1
};

/** Whether leaps are worth what asking for them costs a ray: from a tenth of empty blocks on. */
inline bool isWorthLeaping(const BlockDistances& distances) { return distances.EmptyShare >= 0.1; }

/** By the table's extinction, to the exact entry: a block is seen if it is above 0 anywhere between
 * its least and its greatest scalar, or if undrawnSeen and some value of it is UndrawnScalar. */
BlockDistances findBlockDistances(const BlockRanges& ranges, const IntegralTable& table,
  const ScalarRange& range, bool undrawnSeen);

/** A scalar of several that are drawn together, each with a table of its own. */
struct ShownScalar
{
  const BlockRanges* Ranges = nullptr;
  const IntegralTable* Table = nullptr;
  ScalarRange Range;
};

/** The same of several: a block is seen if one of them shows something of it. That some value is
 * not drawn is known of the first one. */
BlockDistances findBlockDistances(const std::vector<ShownScalar>& scalars, bool undrawnSeen);

/** By surfaces of constant scalar (stored scalars, ascending). */
BlockDistances findBlockDistances(const BlockRanges& ranges, const std::vector<float>& isoValues);

/** The share 0..1 of the blocks of which the table shows nothing. */
double transparentShare(
  const BlockRanges& ranges, const IntegralTable& table, const ScalarRange& range);

} // namespace tetmarch

#endif
