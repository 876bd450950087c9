// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The original block of a cell, in a grid that may have been joined from blocks.
#ifndef TetMarchBlocksCellOrigins_h
#define TetMarchBlocksCellOrigins_h

#include "vtkType.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace tetmarch
{

struct CellOrigin
{
  unsigned int Block; // the flat index in the tree of blocks
  vtkIdType Cell;     // of that block
};

/** By default the origins of a grid without blocks: its cells belong to block 1, as in VTK's
 * mappers. */
class CellOrigins
{
public:
  /** Blocks are added in the order of their cells. */
  void add(unsigned int block, vtkIdType numberOfCells)
  {
    this->Blocks.push_back(block);
    this->Ends.push_back((this->Ends.empty() ? 0 : this->Ends.back()) + numberOfCells);
  }

  /** The grid has new cells: number i comes from cell cells[i] of those before. */
  void renumber(std::vector<vtkIdType>&& cells)
  {
    for (vtkIdType& cell : cells)
    {
      cell = this->before(cell);
    }
    this->Renumbered = std::move(cells);
  }

  CellOrigin of(vtkIdType cell) const
  {
    cell = this->before(cell);
    const std::size_t b =
      std::upper_bound(this->Ends.begin(), this->Ends.end(), cell) - this->Ends.begin();
    return b == this->Ends.size()
             ? CellOrigin{ 1, cell }
             : CellOrigin{ this->Blocks[b], cell - (b ? this->Ends[b - 1] : 0) };
  }

private:
  vtkIdType before(vtkIdType cell) const
  {
    return this->Renumbered.empty() ? cell : this->Renumbered[cell];
  }

  std::vector<unsigned int> Blocks;
  std::vector<vtkIdType> Ends;       // one past the last cell of each block
  std::vector<vtkIdType> Renumbered; // the first number of each cell; empty: no change
};

} // namespace tetmarch

#endif
