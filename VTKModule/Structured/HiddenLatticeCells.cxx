// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/HiddenLatticeCells.h"

#include "Parallel/ParallelFor.h"

#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>

namespace tetmarch
{
namespace
{

using Flags = std::vector<std::uint8_t>;
using Number = std::array<int, 3>; // along i, j and k

std::size_t countOf(const Number& size)
{
  return std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]);
}

std::size_t indexOf(const Number& at, const Number& size)
{
  return (std::size_t(at[2]) * size[1] + at[1]) * size[0] + at[0];
}

Flags flagsOf(vtkUnsignedCharArray* ghosts, unsigned char bits)
{
  if (!hasAny(ghosts, bits))
  {
    return {};
  }
  const unsigned char* values = ghosts->GetPointer(0);
  Flags flags(static_cast<std::size_t>(ghosts->GetNumberOfValues()));
  std::transform(values, values + flags.size(), flags.begin(),
    [bits](unsigned char value) { return (value & bits) != 0 ? 1 : 0; });
  return flags;
}

// The number of set flags among up to eight around a position, and their total number.
struct Around
{
  int Set = 0;
  int Count = 0;
};

// The flags with indices at + first .. at + first + 1 along each axis, as far as they exist.
Around lookAround(const Flags& flags, const Number& size, const Number& at, int first)
{
  Around around;
  for (int c = 0; c < 8; ++c)
  {
    const Number n{ { at[0] + first + (c & 1), at[1] + first + (c >> 1 & 1),
      at[2] + first + (c >> 2) } };
    const bool exists =
      n[0] >= 0 && n[0] < size[0] && n[1] >= 0 && n[1] < size[1] && n[2] >= 0 && n[2] < size[2];
    around.Count += exists ? 1 : 0;
    around.Set += exists && flags[indexOf(n, size)] != 0 ? 1 : 0;
  }
  return around;
}

// Computes the bits of all cells, one word after the other.
template <typename IsHidden>
std::vector<std::uint32_t> bitsOf(const Number& cells, const IsHidden& isHidden)
{
  const std::size_t count = countOf(cells);
  std::vector<std::uint32_t> bits((count + 31) / 32, 0u);
  parallelFor(0, static_cast<vtkIdType>(bits.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (std::size_t c = std::size_t(first) * 32; c < std::min(std::size_t(last) * 32, count);
           ++c)
      {
        const std::size_t row = c / cells[0];
        const Number at{ { int(c % cells[0]), int(row % cells[1]), int(row / cells[1]) } };
        bits[c / 32] |= std::uint32_t(isHidden(c, at) ? 1 : 0) << c % 32;
      }
    });
  const bool any = std::any_of(bits.begin(), bits.end(), [](std::uint32_t word) { return word; });
  return any ? bits : std::vector<std::uint32_t>();
}

bool isSet(const Flags& flags, std::size_t i) { return !flags.empty() && flags[i] != 0; }

// The marked cells of the data, and those with a marked point.
Flags hiddenDataCells(const Flags& cells, const Flags& points, const Number& pointNumbers)
{
  const Number size{ { pointNumbers[0] - 1, pointNumbers[1] - 1, pointNumbers[2] - 1 } };
  const auto bits = bitsOf(size,
    [&](std::size_t c, const Number& at)
    {
      return isSet(cells, c) ||
             (!points.empty() && lookAround(points, pointNumbers, at, 0).Set > 0);
    });
  Flags flags(bits.empty() ? 0 : countOf(size));
  for (std::size_t c = 0; c < flags.size(); ++c)
  {
    flags[c] = bits[c / 32] >> c % 32 & 1u;
  }
  return flags;
}

} // namespace

std::vector<std::uint32_t> hiddenLatticeCells(
  const GhostArrays& ghosts, const std::array<int, 3>& points, const LatticeCase& lies)
{
  const Flags byCells = flagsOf(ghosts.OfCells, HidingCell);
  const Flags byPoints = flagsOf(ghosts.OfPoints, HidingPoint);
  if (byCells.empty() && byPoints.empty())
  {
    return {};
  }
  const Number cells{ { points[0] - 1, points[1] - 1, points[2] - 1 } };
  if (lies.isShifted() && !lies.OfCells)
  {
    return bitsOf(points,
      [&](std::size_t p, const Number& at)
      {
        if (isSet(byPoints, p) || byCells.empty())
        {
          return isSet(byPoints, p);
        }
        const Around around = lookAround(byCells, cells, at, -1);
        return around.Set == around.Count;
      });
  }
  const Flags hidden = hiddenDataCells(byCells, byPoints, points);
  if (hidden.empty())
  {
    return {};
  }
  if (!lies.isShifted())
  {
    return bitsOf(cells, [&](std::size_t c, const Number&) { return hidden[c] != 0; });
  }
  return bitsOf(points,
    [&](std::size_t, const Number& at) { return lookAround(hidden, cells, at, -1).Set > 0; });
}

} // namespace tetmarch
