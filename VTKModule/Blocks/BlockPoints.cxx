// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockPoints.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <unordered_map>

namespace tetmarch
{
namespace
{

using Position = std::array<double, 3>;

struct PositionHash
{
  std::size_t operator()(const Position& position) const
  {
    std::uint64_t hash = 0;
    for (double x : position)
    {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &x, sizeof(x));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

// Points of the joined grid by their key. Several points at one position form a chain.
template <typename Key, typename Hash>
class PointsByKey
{
public:
  // The joined point of a block's next point with this key, or `next` if it is new.
  vtkIdType find(const Key& key, std::size_t block, vtkIdType next)
  {
    const auto found = this->Firsts.try_emplace(key, this->Links.size());
    std::size_t link = found.first->second;
    if (!found.second)
    {
      while (this->Links[link].LastBlock == block && this->Links[link].Next != NoLink)
      {
        link = this->Links[link].Next;
      }
      if (this->Links[link].LastBlock != block)
      {
        this->Links[link].LastBlock = block;
        return this->Links[link].Point;
      }
      this->Links[link].Next = this->Links.size();
    }
    this->Links.push_back({ next, block, NoLink });
    return next;
  }

private:
  static constexpr std::size_t NoLink = static_cast<std::size_t>(-1);
  struct Link
  {
    vtkIdType Point;
    std::size_t LastBlock; // the last block with this point
    std::size_t Next;
  };
  std::unordered_map<Key, std::size_t, Hash> Firsts;
  std::vector<Link> Links;
};

class ByGlobalId
{
public:
  explicit ByGlobalId(const std::vector<vtkDataSet*>& blocks)
  {
    for (vtkDataSet* block : blocks)
    {
      this->Ids.push_back(block->GetPointData()->GetGlobalIds());
    }
  }
  bool isComplete(const std::vector<vtkDataSet*>& blocks) const
  {
    for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      if (!this->Ids[b] || this->Ids[b]->GetNumberOfComponents() != 1 ||
          this->Ids[b]->GetNumberOfTuples() != blocks[b]->GetNumberOfPoints())
      {
        return false;
      }
    }
    return true;
  }
  vtkIdType find(std::size_t block, vtkIdType point, vtkIdType next)
  {
    return this->Points.find(
      static_cast<vtkIdType>(this->Ids[block]->GetComponent(point, 0)), block, next);
  }

private:
  std::vector<vtkDataArray*> Ids;
  PointsByKey<vtkIdType, std::hash<vtkIdType>> Points;
};

class ByPosition
{
public:
  explicit ByPosition(const std::vector<vtkDataSet*>& blocks)
    : Blocks(blocks)
    , Neighbours(blocks.size())
  {
    std::vector<vtkBoundingBox> boxes;
    for (vtkDataSet* block : blocks)
    {
      boxes.emplace_back(block->GetBounds());
    }
    for (std::size_t a = 0; a < blocks.size(); ++a)
    {
      for (std::size_t b = 0; b < blocks.size(); ++b)
      {
        if (a != b && boxes[a].Intersects(boxes[b]))
        {
          this->Neighbours[a].push_back(boxes[b]);
        }
      }
    }
  }
  vtkIdType find(std::size_t block, vtkIdType point, vtkIdType next)
  {
    Position x;
    this->Blocks[block]->GetPoint(point, x.data());
    const std::vector<vtkBoundingBox>& neighbours = this->Neighbours[block];
    if (std::none_of(neighbours.begin(), neighbours.end(),
          [&x](const vtkBoundingBox& box) { return box.ContainsPoint(x.data()); }))
    {
      return next; // no other block has this point
    }
    for (double& coordinate : x)
    {
      coordinate += 0.0; // -0 is 0
    }
    return this->Points.find(x, block, next);
  }

private:
  const std::vector<vtkDataSet*>& Blocks;
  std::vector<std::vector<vtkBoundingBox>> Neighbours;
  PointsByKey<Position, PositionHash> Points;
};

bool isDuplicate(vtkUnsignedCharArray* ghosts, vtkIdType point)
{
  return ghosts && point < ghosts->GetNumberOfTuples() &&
         (ghosts->GetValue(point) & vtkDataSetAttributes::DUPLICATEPOINT) != 0;
}

template <typename Points>
std::vector<BlockPoints> share(
  const std::vector<vtkDataSet*>& blocks, Points& points, vtkIdType& count)
{
  std::vector<BlockPoints> shared(blocks.size());
  count = 0;
  for (const bool duplicates : { false, true })
  {
    for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
        blocks[b]->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
      if (duplicates && !ghosts)
      {
        continue;
      }
      const vtkIdType size = blocks[b]->GetNumberOfPoints();
      shared[b].Joined.resize(static_cast<std::size_t>(size));
      for (vtkIdType p = 0; p < size; ++p)
      {
        if (isDuplicate(ghosts, p) == duplicates)
        {
          const vtkIdType point = points.find(b, p, count);
          shared[b].Joined[static_cast<std::size_t>(p)] = point;
          if (point == count)
          {
            shared[b].Own.push_back(p);
            ++count;
          }
          else if (!duplicates)
          {
            shared[b].Shared.push_back(p);
          }
        }
      }
    }
  }
  return shared;
}

} // namespace

std::vector<BlockPoints> sharePoints(const std::vector<vtkDataSet*>& blocks, vtkIdType& count)
{
  ByGlobalId byId(blocks);
  if (byId.isComplete(blocks))
  {
    return share(blocks, byId, count);
  }
  ByPosition byPosition(blocks);
  return share(blocks, byPosition, count);
}

std::vector<vtkIdType> repeatShared(std::vector<BlockPoints>& blocks, vtkIdType& count)
{
  std::vector<vtkIdType> places;
  for (BlockPoints& block : blocks)
  {
    for (const vtkIdType p : block.Shared)
    {
      vtkIdType& joined = block.Joined[static_cast<std::size_t>(p)];
      places.push_back(joined);
      joined = count++;
      block.Own.push_back(p);
    }
    block.Shared.clear();
  }
  return places;
}

} // namespace tetmarch
