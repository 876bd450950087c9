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

/** The points of a block in the joined grid. */
struct BlockPoints
{
  std::vector<vtkIdType> Joined; // index of each point of the block in the joined grid
  std::vector<vtkIdType> Own;    // points of the block whose data the joined grid uses
  std::vector<vtkIdType> Shared; // others, unless they are marked as duplicates
};

/**
 * Points of different blocks are identified by global ids if all blocks have them
 * (vtkDataSetAttributes::GetGlobalIds), else by equal coordinates. Points of the same block stay
 * separate: of several at one position, the first is joined with the first of another block, the
 * second with the second, and so on. The data of a shared point are those of the first block in
 * which it isn't marked as a duplicate (vtkDataSetAttributes::DUPLICATEPOINT). `count` becomes the
 * number of points of the joined grid.
 */
std::vector<BlockPoints> sharePoints(const std::vector<vtkDataSet*>& blocks, vtkIdType& count);

/** Gives each block points of its own in place of shared ones, behind all others, so that their
 * data are kept. Returns the joined point in whose place each new one lies. */
std::vector<vtkIdType> repeatShared(std::vector<BlockPoints>& blocks, vtkIdType& count);

} // namespace tetmarch

#endif
