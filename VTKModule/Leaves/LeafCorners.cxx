// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Leaves/LeafCorners.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <map>

namespace tetmarch
{
namespace
{

bool isBefore(const LeafPlace& a, const LeafPlace& b)
{
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

// A leaf at one of its corners.
struct Touch
{
  LeafPlace At;
  int LeafNumber;
  int Octant;
};

std::vector<Touch> touchesOf(const std::vector<Leaf>& leaves)
{
  std::vector<Touch> touches(8 * leaves.size());
  for (std::size_t i = 0; i < touches.size(); ++i)
  {
    const Leaf& leaf = leaves[i / 8];
    const int corner = static_cast<int>(i % 8);
    Touch& touch = touches[i];
    for (int a = 0; a < 3; ++a)
    {
      touch.At[a] = leaf.Low[a] + (corner >> a & 1) * leaf.Size[a];
    }
    touch.LeafNumber = static_cast<int>(i / 8);
    touch.Octant = 7 ^ corner;
  }
  vtkSMPTools::Sort(touches.begin(), touches.end(),
    [](const Touch& a, const Touch& b) { return isBefore(a.At, b.At); });
  return touches;
}

// Finds the leaf that contains a cell of the lattice.
class LeafFinder
{
public:
  explicit LeafFinder(const std::vector<Leaf>& leaves)
    : Items(leaves)
  {
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      this->BySize[leaves[i].Size].push_back(static_cast<int>(i));
    }
    for (auto& [size, numbers] : this->BySize)
    {
      std::sort(numbers.begin(), numbers.end(),
        [&](int a, int b) { return isBefore(leaves[a].Low, leaves[b].Low); });
    }
  }

  int leafAt(const LeafPlace& cell) const
  {
    for (const auto& [size, numbers] : this->BySize)
    {
      const int found = this->leafOfSizeAt(size, numbers, cell);
      if (found != NoLeaf)
      {
        return found;
      }
    }
    return NoLeaf;
  }

private:
  // Leaves of one size are aligned: their places differ by multiples of it.
  int leafOfSizeAt(
    const LeafPlace& size, const std::vector<int>& numbers, const LeafPlace& cell) const
  {
    LeafPlace low = this->Items[numbers.front()].Low;
    for (int a = 0; a < 3; ++a)
    {
      const int phase = low[a] % size[a];
      if (cell[a] < phase)
      {
        return NoLeaf;
      }
      low[a] = (cell[a] - phase) / size[a] * size[a] + phase;
    }
    const auto found = std::lower_bound(numbers.begin(), numbers.end(), low,
      [&](int number, const LeafPlace& place) { return isBefore(this->Items[number].Low, place); });
    return found != numbers.end() && this->Items[*found].Low == low ? *found : NoLeaf;
  }

  const std::vector<Leaf>& Items;
  std::map<LeafPlace, std::vector<int>> BySize;
};

} // namespace

std::vector<LeafCorner> cornersOf(const std::vector<Leaf>& leaves)
{
  const std::vector<Touch> touches = touchesOf(leaves);
  const LeafFinder finder(leaves);
  std::vector<LeafCorner> corners;
  for (std::size_t t = 0; t < touches.size();)
  {
    LeafCorner corner{ touches[t].At, {} };
    corner.Around.fill(NoLeaf);
    for (; t < touches.size() && touches[t].At == corner.At; ++t)
    {
      corner.Around[touches[t].Octant] = touches[t].LeafNumber;
    }
    for (int octant = 0; octant < 8; ++octant)
    {
      if (corner.Around[octant] == NoLeaf)
      {
        LeafPlace cell = corner.At;
        for (int a = 0; a < 3; ++a)
        {
          cell[a] -= 1 - (octant >> a & 1);
        }
        corner.Around[octant] = finder.leafAt(cell);
      }
    }
    corners.push_back(corner);
  }
  return corners;
}

} // namespace tetmarch
