// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Transparent blocks of cells, and the length of a ray's leap from each (distance maps: Deakin and
// Knackstedt, "Efficient ray casting of volumetric images using distance maps for empty space
// skipping", 2019).
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

/** The range of scalars in each block: i fastest. */
struct BlockRanges
{
  std::array<int, 3> Blocks{}; // along each axis
  std::vector<std::array<float, 2>>
    Scalars; // minimum and maximum finite stored scalar of all values that cells of the block read;
             // {1, 0} if there is none
  std::vector<std::uint8_t>
    Undrawn; // 1: some value is UndrawnScalar; empty: no value of the lattice is
};

BlockRanges findBlockRanges(const Lattice& lattice, const StoredValues& values);

/**
 * For each block 0 if it may be visible, else the chessboard distance, in blocks, to the nearest
 * one that may be visible: at least 1, at most 255. A block with distance d is the centre of a
 * transparent cube of 2 d - 1 blocks.
 */
struct BlockDistances
{
  std::array<int, 3> Blocks{};
  std::vector<std::uint8_t> Distances;
  double EmptyShare = 0; // of the blocks, 0..1
};

/** Whether leaps are worth their cost for a ray: from a tenth of empty blocks on. */
inline bool isWorthLeaping(const BlockDistances& distances) { return distances.EmptyShare >= 0.1; }

/** By the table's extinction, exact to the entry: a block is visible if the extinction is above 0
 * anywhere between its minimum and its maximum scalar, or if undrawnSeen and one of its values is
 * UndrawnScalar. */
BlockDistances findBlockDistances(const BlockRanges& ranges, const IntegralTable& table,
  const ScalarRange& range, bool undrawnSeen);

/** One of several scalars drawn together, each with its own table. */
struct ShownScalar
{
  const BlockRanges* Ranges = nullptr;
  const IntegralTable* Table = nullptr;
  ScalarRange Range;
};

/** The same for several scalars: a block is visible if it is by one of them. UndrawnScalar occurs
 * in the first one. */
BlockDistances findBlockDistances(const std::vector<ShownScalar>& scalars, bool undrawnSeen);

/** For isosurfaces (stored scalars, ascending). */
BlockDistances findBlockDistances(const BlockRanges& ranges, const std::vector<float>& isoValues);

/** The share 0..1 of the blocks that are transparent by the table. */
double transparentShare(
  const BlockRanges& ranges, const IntegralTable& table, const ScalarRange& range);

} // namespace tetmarch

#endif
