// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Entries/EnteredPixels.h"

#include "Entries/EntryLists.h"

namespace tetmarch
{

// Of each row only the tiles outside of the rectangle of the rows before it are looked at.
EnteredPixels enteredPixels(const EntryLists& lists)
{
  const int columns = lists.TilesPerRow;
  const int rows = static_cast<int>(lists.First.size() - 1) / columns;
  int left = columns;
  int right = 0;
  int bottom = rows;
  int top = 0;
  for (int row = 0; row < rows; ++row)
  {
    const std::uint32_t* first = &lists.First[static_cast<std::size_t>(row) * columns];
    if (first[0] == first[columns])
    {
      continue;
    }
    bottom = row < bottom ? row : bottom;
    top = row + 1;
    for (int column = 0; column < left; ++column)
    {
      left = first[column] < first[column + 1] ? column : left;
    }
    for (int column = columns; column > right; --column)
    {
      right = first[column - 1] < first[column] ? column : right;
    }
  }
  if (right == 0)
  {
    return {};
  }
  const int shift = lists.TileShift;
  return { left << shift, bottom << shift, right << shift, top << shift };
}

} // namespace tetmarch
