// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/Octree.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

constexpr std::uint32_t LeafBit = 0x80000000u;
constexpr std::uint32_t MostNumber = (1u << OctreeNumberBits) - 1u;
constexpr int MostDoublings = 15; // of the width of a node of the table

std::array<int, 3> tableSize(const std::array<int, 3>& places, int shift)
{
  std::array<int, 3> size{};
  std::transform(places.begin(), places.end(), size.begin(),
    [shift](int count) { return ((count - 1) >> shift) + 1; });
  return size;
}

std::size_t nodesOf(const std::array<int, 3>& size)
{
  return std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]);
}

} // namespace

OctreeBuilder::OctreeBuilder(
  const std::array<int, 3>& places, std::size_t leaves, std::uint32_t outside)
  : Outside(LeafBit | outside)
{
  int& shift = this->Made.Shift;
  while (nodesOf(tableSize(places, shift)) > leaves)
  {
    ++shift;
  }
  this->Made.Size = tableSize(places, shift);
  this->Made.Nodes.assign(nodesOf(this->Made.Size), this->Outside);
}

bool OctreeBuilder::set(std::uint32_t& node, std::uint32_t leaf) const
{
  const bool isFree = node == this->Outside;
  node = isFree ? leaf : node;
  return isFree;
}

bool OctreeBuilder::fillTable(const OctreeBox& box, int shift, std::uint32_t number)
{
  const int doublings = shift - this->Made.Shift;
  if (doublings > MostDoublings)
  {
    return false;
  }
  const std::array<int, 3>& size = this->Made.Size;
  std::array<int, 3> begin{}, end{};
  for (int a = 0; a < 3; ++a)
  {
    begin[a] = box.Low[a] >> this->Made.Shift;
    end[a] = std::min(begin[a] + (1 << doublings), size[a]);
  }
  const std::uint32_t leaf =
    LeafBit | static_cast<std::uint32_t>(doublings) << OctreeNumberBits | number;
  bool isFree = true;
  for (int k = begin[2]; k < end[2]; ++k)
  {
    for (int j = begin[1]; j < end[1]; ++j)
    {
      for (int i = begin[0]; i < end[0]; ++i)
      {
        isFree =
          this->set(
            this->Made.Nodes[i + std::size_t(size[0]) * (j + std::size_t(size[1]) * k)], leaf) &&
          isFree;
      }
    }
  }
  return isFree;
}

bool OctreeBuilder::add(const OctreeBox& box, std::uint32_t number)
{
  int shift = 0;
  while (1 << shift < box.Width)
  {
    ++shift;
  }
  const bool isAligned =
    box.Width == 1 << shift &&
    std::all_of(box.Low.begin(), box.Low.end(), [&](int low) { return low % box.Width == 0; });
  if (!isAligned || number >= MostNumber)
  {
    return false;
  }
  if (shift >= this->Made.Shift)
  {
    return this->fillTable(box, shift, number);
  }
  std::vector<std::uint32_t>& nodes = this->Made.Nodes;
  const std::array<int, 3>& size = this->Made.Size;
  const auto atLevel = [&](int axis, int level) { return std::size_t(box.Low[axis]) >> level; };
  int level = this->Made.Shift;
  std::size_t node =
    atLevel(0, level) + size[0] * (atLevel(1, level) + size[1] * atLevel(2, level));
  while (level > shift)
  {
    if (nodes[node] == this->Outside)
    {
      if (nodes.size() >= LeafBit - 8)
      {
        return false;
      }
      nodes[node] = static_cast<std::uint32_t>(nodes.size());
      nodes.insert(nodes.end(), 8, this->Outside);
    }
    else if (nodes[node] & LeafBit)
    {
      return false;
    }
    --level;
    const std::size_t child =
      (atLevel(0, level) & 1) + 2 * (atLevel(1, level) & 1) + 4 * (atLevel(2, level) & 1);
    node = nodes[node] + child;
  }
  return this->set(nodes[node], LeafBit | number);
}

} // namespace tetmarch
