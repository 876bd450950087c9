// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The leaves of an adaptive mesh, found by their places: an octree below a table of equal boxes.
#ifndef TetMarchStructuredOctree_h
#define TetMarchStructuredOctree_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tetmarch
{

/** Bits of a leaf's number in its node. */
constexpr int OctreeNumberBits = 27;
/** Values of leaves lie in rows of 2^10, and 2^10 rows in each layer of an image. */
constexpr int OctreeRowShift = 10;

/**
 * Places are the cells of a lattice, as wide as the smallest leaves. A node is one word: of a leaf
 * bit 31, then in four bits the logarithm of how many nodes of the table it is wide if it is wider
 * than one (to the base 2), and its number; else the index of the first of its eight children,
 * whose number has bit a set on the high side of axis a.
 */
struct Octree
{
  int Shift = 0;                    // a node of the table has 2^Shift places along each axis
  std::array<int, 3> Size{};        // of the table
  std::vector<std::uint32_t> Nodes; // of the table, i fastest; then children, eight by eight
};

/** A cube of places. */
struct OctreeBox
{
  std::array<int, 3> Low;
  int Width;
};

class OctreeBuilder
{
public:
  /** Places along the axes, at most 2^30, and about how many leaves there will be, at least one:
   * the table has no more nodes. What no leaf takes has the number `outside`. */
  OctreeBuilder(const std::array<int, 3>& places, std::size_t leaves, std::uint32_t outside);

  /** False if it is no cube whose width is a power of 2 and divides its place, if another leaf has
   * a part of it, or if the number is too large. */
  bool add(const OctreeBox& box, std::uint32_t number);

  Octree take() { return std::move(this->Made); }

private:
  bool fillTable(const OctreeBox& box, int shift, std::uint32_t number);
  bool set(std::uint32_t& node, std::uint32_t leaf) const;

  Octree Made;
  std::uint32_t Outside; // the node
};

} // namespace tetmarch

#endif
