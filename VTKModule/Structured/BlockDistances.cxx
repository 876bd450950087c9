// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/EmptySpace.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tetmarch
{
namespace
{

constexpr std::uint8_t MostDistance = 255;

// By how much stored scalars and their positions in a table may be rounded, as a share of them.
constexpr double Rounding = 1e-6;

using Distances = std::vector<std::uint8_t>;

template <typename IsSeen>
Distances markSeen(const BlockRanges& ranges, const IsSeen& isSeen)
{
  Distances distances(ranges.Scalars.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(distances.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType b = first; b < last; ++b)
      {
        distances[b] = isSeen(b) ? 0 : MostDistance;
      }
    });
  return distances;
}

// From the distance along i to that in rows: at first it is 0 or MostDistance.
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

// nearest = min(nearest, max(step, other)), for each block of a row.
void takeNearer(std::uint8_t* nearest, const std::uint8_t* other, std::uint8_t step, int count)
{
  for (int i = 0; i < count; ++i)
  {
    nearest[i] = std::min(nearest[i], std::max(step, other[i]));
  }
}

// The chessboard distance, one axis after the other: that in a plane is the least, over the rows of
// the plane, of the greater of the row's distance and the number of rows to it; likewise for the
// volume. Rows are taken nearest first, until none can be nearer.
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
    vtkSMPTools::For(0, vtkIdType(this->Blocks[1]) * this->Blocks[2],
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
  Distances Before; // of the axis before
};

// Of marks that markSeen() made.
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

// Whether a table shows something between two stored scalars.
class SeenOfTable
{
public:
  SeenOfTable(const IntegralTable& table, const ScalarRange& range)
    : Scale(table.scale(range.width()))
    , Offset(table.offset(range.Low))
    , Before(table.Values.size() + 1)
  {
    for (std::size_t i = 0; i < table.Values.size(); ++i)
    {
      this->Before[i + 1] = this->Before[i] + (table.Values[i][3] > 0 ? 1 : 0);
    }
  }

  // Between entries the extinction is linear: it is above 0 less than one entry away from one that
  // has some, and there alone. Scalars may be off by a rounding, but for 0 and 1, the ends of the
  // range: these are exact, and what is transparent there stays so.
  bool operator()(const std::array<float, 2>& scalars) const
  {
    const double low = scalars[0];
    const double high = scalars[1];
    if (!(low <= high))
    {
      return false;
    }
    const double from = std::floor(this->positionOf(low - roundingOf(low)));
    const double to = std::ceil(this->positionOf(high + roundingOf(high)));
    return this->Before[this->entryOf(to) + 1] > this->Before[this->entryOf(from)];
  }

private:
  static double roundingOf(double scalar) { return Rounding * std::min(scalar, 1 - scalar); }
  double positionOf(double scalar) const { return this->Scale * scalar + this->Offset; }
  std::size_t entryOf(double position) const
  {
    return static_cast<std::size_t>(
      std::clamp(position, 0.0, static_cast<double>(this->Before.size() - 2)));
  }

  double Scale;
  double Offset;
  std::vector<std::uint32_t> Before; // how many entries before each one have extinction
};

} // namespace

BlockDistances findBlockDistances(
  const BlockRanges& ranges, const IntegralTable& table, const ScalarRange& range, bool undrawnSeen)
{
  return findBlockDistances({ { &ranges, &table, range } }, undrawnSeen);
}

BlockDistances findBlockDistances(const std::vector<ShownScalar>& scalars, bool undrawnSeen)
{
  std::vector<SeenOfTable> seen;
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
        any = seen[k](scalars[k].Ranges->Scalars[b]);
      }
      return any;
    });
}

BlockDistances findBlockDistances(const BlockRanges& ranges, const std::vector<float>& isoValues)
{
  return distancesTo(ranges,
    [&](vtkIdType b)
    {
      const auto& scalars = ranges.Scalars[b];
      const auto first = std::lower_bound(isoValues.begin(), isoValues.end(),
        double(scalars[0]) - Rounding, [](float v, double limit) { return double(v) < limit; });
      return first != isoValues.end() && double(*first) <= double(scalars[1]) + Rounding;
    });
}

double transparentShare(
  const BlockRanges& ranges, const IntegralTable& table, const ScalarRange& range)
{
  const SeenOfTable seen(table, range);
  return emptyShareOf(markSeen(ranges, [&](vtkIdType b) { return seen(ranges.Scalars[b]); }));
}

} // namespace tetmarch
