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
 * The tree with its blocks that one of the selectors names (vtkDataAssembly::SelectNodes), by
 * themselves or by a block above them. Others are null, so that all keep their flat indices.
 * `assembly` is "Hierarchy", or the name of the assembly of a vtkPartitionedDataSetCollection. A
 * tree without either is taken whole.
 */
vtkSmartPointer<vtkDataObjectTree> selectBlocks(
  vtkDataObjectTree* tree, const std::string& assembly, const std::set<std::string>& selectors);

} // namespace tetmarch

#endif
