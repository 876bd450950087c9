// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The blocks of a composite data set that may be drawn; a data set of its own is the only block.
#ifndef TetMarchBlocksBlockList_h
#define TetMarchBlocksBlockList_h

#include "Blocks/MissingScalars.h"
#include "Caching/Fingerprint.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkDataSet;

namespace tetmarch
{

struct Block
{
  vtkDataSet* Data;
  unsigned int FlatIndex; // in the tree
  std::string Name;       // for messages; empty if it is the only one
  vtkDataArray* Scalars;  // the chosen array; may be null
  bool CellScalars;
};

/** The data sets of the tree except surfaces (vtkPolyData), in the order of the tree. */
std::vector<Block> listBlocks(vtkDataObject* input, const ScalarSelection& selection);

/** Chooses the array of that name of points in place of cells, or the other way, if the block has
 * no other. */
void chooseOfEither(Block& block, ScalarSelection selection);

/** The box of the points of these blocks; not initialised if there are none. */
void boundBlocks(vtkDataObject* input, double bounds[6]);

/** The version of the joined grid without scalars. */
Fingerprint shapeOf(const std::vector<Block>& blocks);
/** The version of the scalars. */
Fingerprint scalarsOf(const std::vector<Block>& blocks);

} // namespace tetmarch

#endif
