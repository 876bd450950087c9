// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel/ParallelFor.h"
#include "Structured/EmptySpace.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace tetmarch
{
namespace
{

// The first and last value along an axis that cells of a block read.
struct ValueSpan
{
  int First;
  int Last;
};

ValueSpan spanOf(const LatticeAxis& axis, bool constant, int block)
{
  const int firstCell = block * BlockSide;
  const int lastCell = std::min(firstCell + BlockSide, axis.Cells) - 1;
  const auto clamped = [&axis](int i) { return std::clamp(i, 0, axis.Values - 1); };
  return { clamped(firstCell + axis.FirstValue),
    clamped(lastCell + axis.FirstValue + (constant ? 0 : 1)) };
}

// The extremes of all added rows of values, separately for each position in a row. Floats may be
// UndrawnScalar, which is above all others.
template <typename Value>
class RowExtremes
{
public:
  RowExtremes(int length, bool hasUndrawn)
    : HasUndrawn(hasUndrawn)
    , Least(static_cast<std::size_t>(length))
    , Greatest(Least.size())
    , GreatestOfAll(hasUndrawn ? Least.size() : 0)
  {
  }

  void clear()
  {
    std::fill(this->Least.begin(), this->Least.end(), std::numeric_limits<Value>::max());
    std::fill(this->Greatest.begin(), this->Greatest.end(), Value(0));
    std::fill(this->GreatestOfAll.begin(), this->GreatestOfAll.end(), Value(0));
  }

  void add(const Value* row)
  {
    Value* least = this->Least.data();
    Value* greatest = this->Greatest.data();
    Value* all = this->GreatestOfAll.data();
    const std::size_t count = this->Least.size();
    if (!this->HasUndrawn)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        least[i] = std::min(least[i], row[i]);
        greatest[i] = std::max(greatest[i], row[i]);
      }
      return;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      least[i] = std::min(least[i], row[i]);
      greatest[i] = std::max(greatest[i], isUndrawn(row[i]) ? Value(0) : row[i]);
      all[i] = std::max(all[i], row[i]);
    }
  }

  // The extremes of the positions in a span. Returns whether some value is drawn.
  bool read(const ValueSpan& span, Value& least, Value& greatest) const
  {
    least =
      *std::min_element(this->Least.begin() + span.First, this->Least.begin() + span.Last + 1);
    greatest = *std::max_element(
      this->Greatest.begin() + span.First, this->Greatest.begin() + span.Last + 1);
    return !this->HasUndrawn || !isUndrawn(least);
  }
  bool hasUndrawn(const ValueSpan& span) const
  {
    return this->HasUndrawn && std::any_of(this->GreatestOfAll.begin() + span.First,
                                 this->GreatestOfAll.begin() + span.Last + 1, isUndrawn);
  }

private:
  static bool isUndrawn(Value value) { return static_cast<float>(value) >= UndrawnScalar; }

  bool HasUndrawn;
  std::vector<Value> Least;
  std::vector<Value> Greatest;
  std::vector<Value> GreatestOfAll; // with UndrawnScalar
};

template <typename Value>
class RangeFinder
{
public:
  RangeFinder(const Lattice& lattice, const StoredValues& values, BlockRanges& ranges)
    : Made(lattice)
    , Values(values)
    , Data(static_cast<const Value*>(values.Data))
    , Ranges(ranges)
    , Zero(values.Offset != 0 ? values.Range.Low : 0)
  {
  }

  void find()
  {
    const std::array<int, 3>& blocks = this->Ranges.Blocks;
    const std::size_t count = std::size_t(blocks[0]) * blocks[1] * blocks[2];
    this->Ranges.Scalars.resize(count);
    const bool undrawn = std::is_same<Value, float>::value && !this->Values.Range.AllFinite;
    this->Ranges.Undrawn.resize(undrawn ? count : 0);
    parallelFor(0, vtkIdType(blocks[1]) * blocks[2],
      [&](vtkIdType first, vtkIdType last)
      {
        RowExtremes<Value> rows(this->Made.Axes[0].Values, undrawn);
        for (vtkIdType row = first; row < last; ++row)
        {
          this->addRows(int(row % blocks[1]), int(row / blocks[1]), rows);
          this->findRow(rows, std::size_t(row) * blocks[0]);
        }
      });
  }

private:
  // All values that the row of blocks j, k reads.
  void addRows(int j, int k, RowExtremes<Value>& rows) const
  {
    const std::array<LatticeAxis, 3>& axes = this->Made.Axes;
    const ValueSpan along = spanOf(axes[1], this->Made.Constant, j);
    const ValueSpan up = spanOf(axes[2], this->Made.Constant, k);
    rows.clear();
    for (int z = up.First; z <= up.Last; ++z)
    {
      for (int y = along.First; y <= along.Last; ++y)
      {
        rows.add(this->Data + (std::size_t(z) * axes[1].Values + y) * axes[0].Values);
      }
    }
  }

  void findRow(const RowExtremes<Value>& rows, std::size_t begin)
  {
    for (int i = 0; i < this->Ranges.Blocks[0]; ++i)
    {
      const ValueSpan span = spanOf(this->Made.Axes[0], this->Made.Constant, i);
      Value least;
      Value greatest;
      const bool any = rows.read(span, least, greatest);
      this->Ranges.Scalars[begin + i] = { { any ? this->scalarOf(least) : 1.0f,
        any ? this->scalarOf(greatest) : 0.0f } };
      if (!this->Ranges.Undrawn.empty())
      {
        this->Ranges.Undrawn[begin + i] = rows.hasUndrawn(span) ? 1 : 0;
      }
    }
  }

  // For integers without the roundings of Scale and Offset: exactly 0 and 1 at the ends of the
  // range.
  float scalarOf(Value value) const
  {
    return std::is_same<Value, float>::value
             ? static_cast<float>(value)
             : static_cast<float>(
                 (static_cast<double>(value) - this->Zero) / this->Values.Range.width());
  }

  const Lattice& Made;
  const StoredValues& Values;
  const Value* Data;
  BlockRanges& Ranges;
  double Zero; // the integer that represents scalar 0
};

} // namespace

BlockRanges findBlockRanges(const Lattice& lattice, const StoredValues& values)
{
  BlockRanges ranges;
  for (int a = 0; a < 3; ++a)
  {
    ranges.Blocks[a] = (lattice.Axes[a].Cells + BlockSide - 1) / BlockSide;
  }
  switch (values.Type)
  {
    case ValueType::UInt8:
      RangeFinder<std::uint8_t>(lattice, values, ranges).find();
      break;
    case ValueType::UInt16:
      RangeFinder<std::uint16_t>(lattice, values, ranges).find();
      break;
    case ValueType::Float32:
      RangeFinder<float>(lattice, values, ranges).find();
      break;
  }
  return ranges;
}

} // namespace tetmarch
