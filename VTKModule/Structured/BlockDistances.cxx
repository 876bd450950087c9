// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel/ParallelFor.h"
#include "Structured/EmptySpace.h"

#include "Scalars/SeenScalars.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tetmarch
{
namespace
{

constexpr std::uint8_t MostDistance = 255;

using Distances = std::vector<std::uint8_t>;

template <typename IsSeen>
Distances markSeen(const BlockRanges& ranges, const IsSeen& isSeen)
{
  Distances distances(ranges.Scalars.size());
  parallelFor(0, static_cast<vtkIdType>(distances.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType b = first; b < last; ++b)
      {
        distances[b] = isSeen(b) ? 0 : MostDistance;
      }
    });
  return distances;
}

// Computes distances along i in a row, which initially contains 0 or MostDistance.
void spreadAlongRow(std::uint8_t* row, int count)
{
  for (int i = 1; i < count; ++i)
  {
    row[i] = static_cast<std::uint8_t>(std::min<int>(row[i], row[i - 1] + 1));
  }
  for (int i = count - 2; i >= 0; --i)
  {
    row[i] = static_cast<std::uint8_t>(std::min<int>(row[i], row[i + 1] + 1));
  }
}

// nearest = min(nearest, max(step, other)) for each block of a row.
void takeNearer(std::uint8_t* nearest, const std::uint8_t* other, std::uint8_t step, int count)
{
  for (int i = 0; i < count; ++i)
  {
    nearest[i] = std::min(nearest[i], std::max(step, other[i]));
  }
}

// The chessboard distance, one axis after the other: in a plane it is the minimum, over the rows of
// the plane, of the maximum of the row's distance and the number of rows to it; likewise for the
// volume. Rows are visited nearest first, until none can be nearer.
class ChessboardDistance
{
public:
  ChessboardDistance(const std::array<int, 3>& blocks, Distances& distances)
    : Blocks(blocks)
    , Values(distances)
    , Before(distances.size())
  {
  }

  void find()
  {
    this->forRows([&](int, int, std::uint8_t* row) { spreadAlongRow(row, this->Blocks[0]); });
    this->spread(1);
    this->spread(2);
  }

private:
  template <typename Work>
  void forRows(const Work& work)
  {
    parallelFor(0, vtkIdType(this->Blocks[1]) * this->Blocks[2],
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType row = first; row < last; ++row)
        {
          work(int(row % this->Blocks[1]), int(row / this->Blocks[1]),
            this->Values.data() + std::size_t(row) * this->Blocks[0]);
        }
      });
  }

  void spread(int axis)
  {
    this->Before = this->Values;
    const std::ptrdiff_t stride =
      std::ptrdiff_t(this->Blocks[0]) * (axis == 2 ? this->Blocks[1] : 1);
    this->forRows(
      [&](int j, int k, std::uint8_t* row)
      {
        const int at = axis == 1 ? j : k;
        const int count = this->Blocks[0];
        const std::uint8_t* before = this->Before.data() + (row - this->Values.data());
        for (int step = 1; step < *std::max_element(row, row + count); ++step)
        {
          const bool down = at - step >= 0;
          const bool up = at + step < this->Blocks[axis];
          if (!down && !up)
          {
            break;
          }
          if (down)
          {
            takeNearer(row, before - step * stride, static_cast<std::uint8_t>(step), count);
          }
          if (up)
          {
            takeNearer(row, before + step * stride, static_cast<std::uint8_t>(step), count);
          }
        }
      });
  }

  std::array<int, 3> Blocks;
  Distances& Values;
  Distances Before; // of the previous axis
};

// The share of empty blocks in the marks of markSeen().
double emptyShareOf(const Distances& marks)
{
  return marks.empty() ? 0
                       : static_cast<double>(std::count(marks.begin(), marks.end(), MostDistance)) /
                           static_cast<double>(marks.size());
}

template <typename IsSeen>
BlockDistances distancesTo(const BlockRanges& ranges, const IsSeen& isSeen)
{
  BlockDistances made{ ranges.Blocks, markSeen(ranges, isSeen), 0 };
  made.EmptyShare = emptyShareOf(made.Distances);
  if (made.EmptyShare < 1)
  {
    ChessboardDistance(made.Blocks, made.Distances).find();
  }
  return made;
}

} // namespace

BlockDistances findBlockDistances(
  const BlockRanges& ranges, const IntegralTable& table, const ScalarRange& range, bool undrawnSeen)
{
  return findBlockDistances({ { &ranges, &table, range } }, undrawnSeen);
}

BlockDistances findBlockDistances(const std::vector<ShownScalar>& scalars, bool undrawnSeen)
{
  std::vector<SeenScalars> seen;
  seen.reserve(scalars.size());
  for (const ShownScalar& scalar : scalars)
  {
    seen.emplace_back(*scalar.Table, scalar.Range);
  }
  const BlockRanges& first = *scalars.front().Ranges;
  const bool undrawn = undrawnSeen && !first.Undrawn.empty();
  return distancesTo(first,
    [&](vtkIdType b)
    {
      bool any = undrawn && first.Undrawn[b] != 0;
      for (std::size_t k = 0; k < seen.size() && !any; ++k)
      {
        const auto& range = scalars[k].Ranges->Scalars[b];
        any = seen[k].between(range[0], range[1]);
      }
      return any;
    });
}

BlockDistances findBlockDistances(const BlockRanges& ranges, const std::vector<float>& isoValues)
{
  return distancesTo(ranges, [&](vtkIdType b)
    { return isAnyBetween(isoValues, ranges.Scalars[b][0], ranges.Scalars[b][1]); });
}

double transparentShare(
  const BlockRanges& ranges, const IntegralTable& table, const ScalarRange& range)
{
  const SeenScalars seen(table, range);
  return emptyShareOf(markSeen(
    ranges, [&](vtkIdType b) { return seen.between(ranges.Scalars[b][0], ranges.Scalars[b][1]); }));
}

} // namespace tetmarch
