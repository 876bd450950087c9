// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which points the blocks of a data set share.
#ifndef TetMarchBlocksBlockPoints_h
#define TetMarchBlocksBlockPoints_h

#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace tetmarch
{

/** Where the points of a block are among those of all blocks together. */
struct BlockPoints
{
  std::vector<vtkIdType> Joined; // of each point of the block: its number in the whole
  std::vector<vtkIdType> Own;    // points of the block that are those of the whole
};

/**
 * Points of different blocks are one if they have the same global id, where all blocks have such
 * (vtkDataSetAttributes::GetGlobalIds), or else the same coordinates to the last bit. Points of the
 * same block stay apart: of several in one place, the first is one with the first of another block,
 * and so on. A shared point is that of the first block in which it isn't marked as a duplicate
 * (vtkDataSetAttributes::DUPLICATEPOINT). `count` becomes the number of points of the whole.
 */
std::vector<BlockPoints> sharePoints(const std::vector<vtkDataSet*>& blocks, vtkIdType& count);

} // namespace tetmarch

#endif
