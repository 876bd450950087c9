// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The visible blocks of composite data, chosen by ParaView's Multi-block Inspector.
#ifndef TetMarchSelectedBlocks_h
#define TetMarchSelectedBlocks_h

#include "vtkDataObjectTree.h"
#include "vtkSmartPointer.h"

#include <set>
#include <string>

namespace tetmarch
{

/**
 * The blocks selected by one of the selectors (vtkDataAssembly::SelectNodes), directly or by a
 * parent block. `Assembly` is "Hierarchy", or the name of the assembly of a
 * vtkPartitionedDataSetCollection. By default all blocks.
 */
struct BlockSelection
{
  std::string Assembly = "Hierarchy";
  std::set<std::string> Selectors{ "/" };
};

/**
 * The tree with its selected blocks. Others are null, so that all keep their flat indices. A tree
 * without hierarchy and assembly is not changed.
 */
vtkSmartPointer<vtkDataObjectTree> selectBlocks(
  vtkDataObjectTree* tree, const BlockSelection& selection);

} // namespace tetmarch

#endif
