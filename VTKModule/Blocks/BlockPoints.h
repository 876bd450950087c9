// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the points that the blocks of a data set share.
#ifndef TetMarchBlocksBlockPoints_h
#define TetMarchBlocksBlockPoints_h

#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace tetmarch
{

/** Where the points of a block are in the joined grid. */
struct BlockPoints
{
  std::vector<vtkIdType> Joined; // of each point of the block: its number in the joined grid
  std::vector<vtkIdType> Own;    // points of the block whose data the joined grid takes
};

/**
 * Points of different blocks are one point if they have the same global id, where all blocks have
 * global ids (vtkDataSetAttributes::GetGlobalIds), or else exactly the same coordinates. Points of
 * the same block stay apart: of several in one place, the first is joined with the first of another
 * block, the second with the second, and so on. The data of a shared point is that of the first
 * block in which it isn't marked as a duplicate (vtkDataSetAttributes::DUPLICATEPOINT). `count`
 * becomes the number of points of the joined grid.
 */
std::vector<BlockPoints> sharePoints(const std::vector<vtkDataSet*>& blocks, vtkIdType& count);

} // namespace tetmarch

#endif
