// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of blocks as arrays of the whole.
#ifndef TetMarchBlocksBlockArrays_h
#define TetMarchBlocksBlockArrays_h

#include "Blocks/BlockPoints.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataArray;
class vtkPoints;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace tetmarch
{

/** Blocks with where their points are in the whole, of which there are `Count`. */
struct SharedBlocks
{
  std::vector<vtkDataSet*> Data;
  std::vector<BlockPoints> Points;
  vtkIdType Count = 0;
};

/** In double precision if any block has its points so, else as they are. */
vtkSmartPointer<vtkPoints> joinPoints(const SharedBlocks& blocks);
/** Give the grid, which has none, all cells in the order of the blocks, polyhedra with their faces.
 * They are sound (checkGrid). */
void joinCells(const SharedBlocks& blocks, vtkUnstructuredGrid* grid);

/** Values of points or cells by one array a block of the same number of components each: of the
 * type that all of them have, or else in double precision. */
vtkSmartPointer<vtkDataArray> joinPointValues(
  const SharedBlocks& blocks, const std::vector<vtkDataArray*>& arrays);
vtkSmartPointer<vtkDataArray> joinCellValues(
  const SharedBlocks& blocks, const std::vector<vtkDataArray*>& arrays);

/** Which points or cells are ghosts; null if no block has such an array. A shared point is what it
 * is in all of its blocks. */
vtkSmartPointer<vtkUnsignedCharArray> joinPointGhosts(const SharedBlocks& blocks);
vtkSmartPointer<vtkUnsignedCharArray> joinCellGhosts(const SharedBlocks& blocks);

} // namespace tetmarch

#endif
