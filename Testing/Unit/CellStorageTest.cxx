// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells make the same mesh whatever they are kept in: from VTK 9.6 on that may be arrays that
// compute their values, for cells of one type and of one size.
#include "Input/CellTypes.h"
#include "Input/GridContent.h"
#include "Input/SolidCells.h"
#include "Mesh/LeastTetrahedra.h"
#include "UnitMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

GridContent contentOf(vtkUnstructuredGrid* grid)
{
  GridContent content;
  content.read(grid);
  return content;
}

// The lattice's tetrahedra, told their type once for all.
Grid ofOneType()
{
  Grid grid = jitteredLattice(3);
  grid->SetCells(VTK_TETRA, grid->GetCells());
  return grid;
}

Grid ofOneSize()
{
  Grid grid = ofOneType();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  EXPECT_TRUE(grid->GetCells()->ConvertToFixedSizeDefaultStorage());
#endif
  return grid;
}

void expectSameMesh(vtkUnstructuredGrid* grid)
{
  const Grid stored = jitteredLattice(3);
  const CellTypes types(grid);
  EXPECT_EQ(types[0], VTK_TETRA);
  EXPECT_EQ(types[grid->GetNumberOfCells() - 1], VTK_TETRA);
  EXPECT_EQ(built(grid).Tets, built(stored).Tets);
  EXPECT_EQ(leastTetrahedra(grid, 0), leastTetrahedra(stored, 0));
  EXPECT_TRUE(hasSolidCells(grid));
}

TEST(CellStorage, CellsOfOneType) { expectSameMesh(ofOneType()); }
TEST(CellStorage, CellsOfOneSize) { expectSameMesh(ofOneSize()); }

TEST(CellStorage, IsKnownAgain)
{
  EXPECT_TRUE(contentOf(ofOneSize()) == contentOf(ofOneSize()));
  const Grid other = ofOneSize();
  other->SetCells(VTK_QUAD, other->GetCells());
  EXPECT_FALSE(contentOf(other) == contentOf(ofOneSize()));
}
} // namespace
