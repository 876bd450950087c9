// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A fixture that joins grids, and the arrays to choose from
 */
#ifndef tetmarch_testing_JoinedGrids_h
#define tetmarch_testing_JoinedGrids_h

#include "Blocks/JoinedBlocks.h"
#include "GridBlocks.h"

#include "vtkAbstractMapper.h"

#include <gtest/gtest.h>

namespace tetmarch::testing
{
inline const ScalarSelection ActiveScalars{ VTK_SCALAR_MODE_DEFAULT, 0, 0, nullptr };

inline ScalarSelection pointArray(const char* name)
{
  return { VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, VTK_GET_ARRAY_BY_NAME, 0, name };
}
inline ScalarSelection cellArray(const char* name)
{
  return { VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, VTK_GET_ARRAY_BY_NAME, 0, name };
}

class Joined : public ::testing::Test
{
protected:
  void join(const std::vector<Grid>& grids, const ScalarSelection& selection = ActiveScalars)
  {
    this->Input = blocks(grids);
    EXPECT_EQ(this->Blocks.update(this->Input, selection), "");
  }
  vtkUnstructuredGrid* grid() { return this->Blocks.grid(); }

  vtkSmartPointer<vtkMultiBlockDataSet> Input;
  JoinedBlocks Blocks;
};
} // namespace tetmarch::testing

#endif
