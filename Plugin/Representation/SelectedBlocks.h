// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The blocks of composite data that are to be seen, as ParaView's Multi-block Inspector has them
// chosen.
#ifndef TetMarchSelectedBlocks_h
#define TetMarchSelectedBlocks_h

#include "vtkDataObjectTree.h"
#include "vtkSmartPointer.h"

#include <set>
#include <string>

namespace tetmarch
{

/**
 * Those that one of the selectors names (vtkDataAssembly::SelectNodes), by themselves or by a block
 * above them. `Assembly` is "Hierarchy", or the name of the assembly of a
 * vtkPartitionedDataSetCollection. By default all blocks.
 */
struct BlockSelection
{
  std::string Assembly = "Hierarchy";
  std::set<std::string> Selectors{ "/" };
};

/**
 * The tree with its blocks that are selected. Others are null, so that all keep their flat indices.
 * A tree without hierarchy and assembly is taken whole.
 */
vtkSmartPointer<vtkDataObjectTree> selectBlocks(
  vtkDataObjectTree* tree, const BlockSelection& selection);

} // namespace tetmarch

#endif
