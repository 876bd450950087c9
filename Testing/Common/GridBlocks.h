// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A grid cut into blocks that have points of their own
 */
#ifndef tetmarch_testing_GridBlocks_h
#define tetmarch_testing_GridBlocks_h

#include "GridBuilder.h"

#include "vtkMultiBlockDataSet.h" // what blocks() gives is used with ->

#include <functional>

namespace tetmarch::testing
{
/// Which block a cell belongs to, by the mean of its points.
using BlockOf = std::function<int(const Vec3& centre)>;

/// By halves or thirds of the unit cube along axes: 2, 3 or 8 blocks.
BlockOf partsOfUnitCube(int count);

/// The cells of each block in the order that they have, with their "f" and "c". Points lie in the
/// order of the grid and have its numbers as global ids, if asked for.
std::vector<Grid> cutIntoBlocks(
  vtkUnstructuredGrid* grid, const BlockOf& blockOf, bool withGlobalIds = false);

vtkSmartPointer<vtkMultiBlockDataSet> blocks(const std::vector<Grid>& grids);

/// The block with this flat index; nullptr if there is none.
vtkDataSet* blockAt(vtkCompositeDataSet* data, unsigned int flatIndex);
} // namespace tetmarch::testing

#endif
