// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Of a piece of a volume the cells that another process draws are left out, and nothing else.
#include "Blocks/OwnCells.h"

#include "Grids.h"
#include "LatticeImages.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr int Duplicate = vtkDataSetAttributes::DUPLICATECELL;

// Every third cell is drawn by another process.
bool isOwn(vtkIdType cell) { return cell % 3 != 1; }

// Its type, its points and, of a polyhedron, its faces.
std::vector<vtkIdType> shapeOf(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  grid->GetFaceStream(cell, ids);
  std::vector<vtkIdType> shape{ grid->GetCellType(cell) };
  shape.insert(shape.end(), ids->begin(), ids->end());
  return shape;
}

class OwnCellsOf : public ::testing::Test
{
protected:
  vtkDataArray* scalars(bool ofCells)
  {
    return ofCells ? this->Data->GetCellData()->GetScalars()
                   : this->Data->GetPointData()->GetScalars();
  }
  // Marks of other kinds stay as they are.
  void markOthers()
  {
    markCells(this->Data, vtkDataSetAttributes::HIDDENCELL, [](vtkIdType i) { return i % 2 == 0; });
    markCells(this->Data, Duplicate, [](vtkIdType i) { return !isOwn(i); });
    markPoints(this->Data, vtkDataSetAttributes::HIDDENPOINT, [](vtkIdType i) { return i == 5; });
  }
  void update(bool ofCells)
  {
    this->Own.update(this->Data, this->scalars(ofCells), ofCells, this->Origins);
  }

  Grid Data = mixedCells(3);
  CellOrigins Origins;
  OwnCells Own;
};

TEST_F(OwnCellsOf, GridsOfAnyCellsAreTheirCellsWithoutDuplicates)
{
  for (const Grid& grid : { mixedCells(3), polyhedronLattice(2, 0.1) })
  {
    for (const bool ofCells : { false, true })
    {
      SCOPED_TRACE(std::to_string(grid->GetCellType(0)) + (ofCells ? ", cells" : ", points"));
      this->Data = grid;
      this->markOthers();
      this->Origins = {};
      this->Origins.add(4, 5);
      this->Origins.add(7, grid->GetNumberOfCells() - 5);
      this->update(ofCells);
      vtkUnstructuredGrid* own = this->Own.grid();
      ASSERT_EQ(own->GetPoints(), grid->GetPoints());
      EXPECT_EQ(own->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()),
        grid->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
      EXPECT_STREQ(this->Own.scalars()->GetName(), this->scalars(ofCells)->GetName());
      vtkIdType kept = 0;
      for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
      {
        if (isOwn(i))
        {
          ASSERT_LT(kept, own->GetNumberOfCells());
          EXPECT_EQ(shapeOf(own, kept), shapeOf(grid, i)) << i;
          EXPECT_EQ(own->GetCellGhostArray()->GetValue(kept), i % 2 ? 0 : 32) << i;
          EXPECT_EQ(this->Own.origins().of(kept).Block, i < 5 ? 4u : 7u) << i;
          EXPECT_EQ(this->Own.origins().of(kept).Cell, i < 5 ? i : i - 5) << i;
          if (ofCells)
          {
            EXPECT_EQ(
              this->Own.scalars()->GetComponent(kept, 0), this->scalars(true)->GetComponent(i, 0))
              << i;
          }
          ++kept;
        }
      }
      EXPECT_EQ(kept, own->GetNumberOfCells());
      EXPECT_TRUE(ofCells || this->Own.scalars() == this->scalars(false));
    }
  }
}

TEST_F(OwnCellsOf, GridsWithoutDuplicatesAreThemselves)
{
  const Grid plain = mixedCells(3), marked = mixedCells(3);
  markCells(plain, vtkDataSetAttributes::HIDDENCELL, [](vtkIdType i) { return !isOwn(i); });
  markCells(marked, Duplicate, [](vtkIdType i) { return !isOwn(i); });
  this->Origins.add(4, plain->GetNumberOfCells());
  for (const Grid& grid : { plain, marked, plain, marked })
  {
    this->Data = grid;
    this->update(true);
    EXPECT_EQ(this->Own.grid() == grid, grid == plain);
    EXPECT_EQ(this->Own.scalars() == this->scalars(true), grid == plain);
    EXPECT_EQ(this->Own.origins().of(2).Cell, grid == plain ? 2 : 3);
    EXPECT_EQ(this->Own.origins().of(2).Block, 4u);
  }
}

// A mesh made of the cells is kept as long as they are the same grid.
TEST_F(OwnCellsOf, AreMadeAgainIfTheGridItsMarksOrScalarsChange)
{
  this->markOthers();
  const std::function<void()> changes[] = { [&] { this->Data->GetPoints()->Modified(); },
    [&] { this->scalars(true)->Modified(); },
    [&]
    {
      this->Data->GetCellGhostArray()->SetValue(0, Duplicate);
      this->Data->GetCellGhostArray()->Modified();
    },
    [&] { this->Data->GetPointGhostArray()->Modified(); } };
  for (const auto& change : changes)
  {
    this->update(true);
    const vtkSmartPointer<vtkUnstructuredGrid> before = this->Own.grid();
    this->update(true);
    EXPECT_EQ(this->Own.grid(), before);
    change();
    this->update(true);
    EXPECT_NE(this->Own.grid(), before);
  }
  EXPECT_EQ(this->Own.origins().of(0).Cell, 2);
  this->Own.update(this->Data, nullptr, false, this->Origins);
  EXPECT_EQ(this->Own.scalars(), nullptr);
}
} // namespace
