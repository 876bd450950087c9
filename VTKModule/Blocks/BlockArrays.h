// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Joins the arrays of blocks.
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

/** Blocks that share points, and the positions of their points among the `Count` points of the
 * joined grid. */
struct SharedBlocks
{
  std::vector<vtkDataSet*> Data;
  std::vector<BlockPoints> Points;
  vtkIdType Count = 0;
  std::vector<std::vector<bool>> Refined; // cells that are left out, of each block; may be empty
  std::vector<vtkIdType> Places; // of the last points: those with the same positions (repeatShared)
};

/** The joined points: in double precision if those of any block are, else in their own type.
 */
vtkSmartPointer<vtkPoints> joinPoints(const SharedBlocks& blocks);
/** Add the cells of all blocks to the empty grid, in the order of the blocks, polyhedra with their
 * faces, refined ones as VTK_EMPTY_CELL. The cells must be valid (checkGrid). */
void joinCells(const SharedBlocks& blocks, vtkUnstructuredGrid* grid);

/** Join one array of each block; all have the same number of components. The result has their
 * common type, or else double precision. */
vtkSmartPointer<vtkDataArray> joinPointValues(
  const SharedBlocks& blocks, const std::vector<vtkDataArray*>& arrays);
/** Whether a shared point has other values in another block. `values`: of joinPointValues(). */
bool valuesDiffer(
  const SharedBlocks& blocks, const std::vector<vtkDataArray*>& arrays, vtkDataArray* values);
vtkSmartPointer<vtkDataArray> joinCellValues(
  const SharedBlocks& blocks, const std::vector<vtkDataArray*>& arrays);

/** Join the ghost arrays; null if no block has one. A shared point has only the flags that it has
 * in all of its blocks, also where it is repeated. */
vtkSmartPointer<vtkUnsignedCharArray> joinPointGhosts(const SharedBlocks& blocks);
vtkSmartPointer<vtkUnsignedCharArray> joinCellGhosts(const SharedBlocks& blocks);

} // namespace tetmarch

#endif
