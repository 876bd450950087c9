// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of an adaptive mesh that finer blocks replace.
#ifndef TetMarchBlocksRefinedCells_h
#define TetMarchBlocksRefinedCells_h

#include "Blocks/BlockList.h"

#include <vector>

namespace tetmarch
{

/** For each cell of each of these blocks of a vtkOverlappingAMR, whether one with a smaller spacing
 * covers it. Without blocks for other data sets. The blocks must be valid (checkData);
 * their boxes follow from origin, spacing and dimensions. */
std::vector<std::vector<bool>> refinedCells(vtkDataObject* input, const std::vector<Block>& drawn);

} // namespace tetmarch

#endif
