// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks of curved cells, which are cut when they have been joined.
#include "FilledCube.h"
#include "Grids.h"
#include "JoinedGrids.h"
#include "QuadraticGrids.h"

#include "Blocks/OwnCells.h"
#include "Scalars/GhostArrays.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <set>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr double Tolerance = 0.01;

double parabola(double x, double y, double z) { return x * x - y * z; }

Grid lattice() { return quadraticHexLattice(2, 0.1, parabola); }

class CurvedBlocks : public Joined
{
protected:
  void cut(vtkDataObject* input, const ScalarSelection& selection = ActiveScalars)
  {
    EXPECT_EQ(this->Blocks.update(input, selection, { Tolerance }), "");
    ASSERT_NE(this->grid(), nullptr);
  }
};

TEST_F(CurvedBlocks, FillTheCubeWithoutGaps)
{
  for (const int count : { 2, 8 })
  {
    this->cut(blocks(cutIntoBlocks(lattice(), partsOfUnitCube(count))));
    EXPECT_GT(this->grid()->GetNumberOfCells(), 500);
    expectFillsTheCube(this->grid());
  }
}

TEST_F(CurvedBlocks, TetrahedraTellTheirCellAndItsBlock)
{
  const std::vector<Grid> halves = cutIntoBlocks(lattice(), partsOfUnitCube(2));
  this->cut(blocks(halves), cellArray("c"));
  std::set<std::pair<unsigned int, vtkIdType>> told;
  for (vtkIdType tet = 0; tet < this->grid()->GetNumberOfCells(); ++tet)
  {
    const CellOrigin origin = this->Blocks.origins().of(tet);
    ASSERT_TRUE(origin.Block == 1 || origin.Block == 2);
    vtkDataArray* values = halves[origin.Block - 1]->GetCellData()->GetArray("c");
    ASSERT_LT(origin.Cell, values->GetNumberOfTuples());
    EXPECT_EQ(this->Blocks.scalars()->GetComponent(tet, 0), values->GetComponent(origin.Cell, 0));
    told.emplace(origin.Block, origin.Cell);
  }
  EXPECT_EQ(told.size(), 8u);
}

TEST_F(CurvedBlocks, AreCutAnewForOtherScalarsAndTolerances)
{
  const Grid grid = lattice();
  this->cut(grid);
  const vtkIdType first = this->grid()->GetNumberOfCells();
  this->cut(grid);
  EXPECT_EQ(this->Blocks.record().Runs, 1);
  vtkNew<vtkDoubleArray> flat;
  flat->SetName("f");
  flat->SetNumberOfTuples(grid->GetNumberOfPoints());
  flat->FillComponent(0, 3);
  grid->GetPointData()->SetScalars(flat);
  this->cut(grid);
  EXPECT_LT(this->grid()->GetNumberOfCells(), first);
  EXPECT_EQ(this->Blocks.scalars()->GetRange()[0], 3);
  flat->SetNumberOfTuples(3);
  flat->Modified();
  EXPECT_NE(this->Blocks.update(grid, ActiveScalars, { Tolerance }), "");
  EXPECT_EQ(this->grid(), nullptr);
  flat->SetNumberOfTuples(grid->GetNumberOfPoints());
  flat->FillComponent(0, 3);
  flat->Modified();
  EXPECT_EQ(this->Blocks.update(grid, ActiveScalars, { 1 }), "");
  EXPECT_EQ(this->grid()->GetNumberOfCells(), 6 * 8);
  EXPECT_EQ(this->Blocks.update(grid, ActiveScalars), "");
  EXPECT_EQ(this->grid(), grid);
  EXPECT_EQ(this->Blocks.scalars(), flat);
}

TEST_F(CurvedBlocks, OthersAreDrawnThemselves)
{
  const Grid grid = jitteredLattice(3);
  this->cut(grid);
  EXPECT_EQ(this->grid(), grid);
}

TEST_F(CurvedBlocks, StayHidden)
{
  const Grid grid = lattice();
  vtkNew<vtkUnsignedCharArray> ofPoints;
  ofPoints->SetName(vtkDataSetAttributes::GhostArrayName());
  ofPoints->SetNumberOfTuples(grid->GetNumberOfPoints());
  ofPoints->FillComponent(0, 0);
  ofPoints->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  grid->GetPointData()->AddArray(ofPoints);
  vtkNew<vtkUnsignedCharArray> ofCells;
  ofCells->SetName(vtkDataSetAttributes::GhostArrayName());
  ofCells->SetNumberOfTuples(grid->GetNumberOfCells());
  ofCells->FillComponent(0, 0);
  ofCells->SetValue(grid->GetNumberOfCells() - 1, vtkDataSetAttributes::REFINEDCELL);
  grid->GetCellData()->AddArray(ofCells);
  this->cut(grid);
  const GhostArrays ghosts = ghostArraysOf(this->grid());
  ASSERT_NE(ghosts.OfCells, nullptr);
  std::set<vtkIdType> hidden;
  for (vtkIdType tet = 0; tet < this->grid()->GetNumberOfCells(); ++tet)
  {
    if (ghosts.OfCells->GetValue(tet) & HidingCell)
    {
      hidden.insert(this->Blocks.origins().of(tet).Cell);
    }
  }
  EXPECT_EQ(hidden, (std::set<vtkIdType>{ 0, grid->GetNumberOfCells() - 1 }));
}

// Of several processes: what another one draws is left out, and the rest tells its cells.
TEST_F(CurvedBlocks, TellTheirCellsWithoutThoseOfOthers)
{
  const Grid grid = lattice();
  grid->AllocateCellGhostArray();
  grid->GetCellGhostArray()->SetValue(0, vtkDataSetAttributes::DUPLICATECELL);
  this->cut(grid);
  OwnCells own;
  own.update(this->grid(), this->Blocks.scalars(), false, this->Blocks.origins());
  std::set<vtkIdType> told;
  for (vtkIdType tet = 0; tet < own.grid()->GetNumberOfCells(); ++tet)
  {
    told.insert(own.origins().of(tet).Cell);
  }
  EXPECT_EQ(told, (std::set<vtkIdType>{ 1, 2, 3, 4, 5, 6, 7 }));
}

TEST_F(CurvedBlocks, AreCutLaterIfTheyWereStopped)
{
  const Grid grid = lattice();
  const auto stop = [](double) { return false; };
  EXPECT_EQ(this->Blocks.update(grid, ActiveScalars, { Tolerance }, stop), "");
  EXPECT_EQ(this->grid(), nullptr);
  this->cut(grid);
  expectFillsTheCube(this->grid());
}

// They are cut again for it, but not when it is no longer asked for.
TEST_F(CurvedBlocks, AreMeasuredIfThatIsAskedFor)
{
  const Grid grid = lattice();
  this->cut(grid);
  EXPECT_FALSE(isAny(this->Blocks.departure()));
  const CurvedOptions measured{ Tolerance, true };
  const auto runsOf = [&](const CurvedOptions& options)
  {
    EXPECT_EQ(this->Blocks.update(grid, ActiveScalars, options), "");
    EXPECT_GT(this->Blocks.grid()->GetNumberOfCells(), 48);
    return this->Blocks.record().Runs;
  };
  EXPECT_EQ(runsOf(measured), 2);
  const CurvedDeparture departure = this->Blocks.departure();
  EXPECT_GT(departure.Distance, 0);
  EXPECT_GT(departure.Value, 0);
  EXPECT_EQ(runsOf({ Tolerance }), 2);
  EXPECT_EQ(runsOf(measured), 2);
  EXPECT_EQ(this->Blocks.departure().Value, departure.Value);
  this->Blocks.update(grid, ActiveScalars);
  EXPECT_FALSE(isAny(this->Blocks.departure()));
}

// A curved edge may leave the box of its points.
TEST_F(CurvedBlocks, HaveTheBoxOfTheirCutCells)
{
  const Grid grid = quadraticTetLattice(1);
  vtkDataArray* points = grid->GetPoints()->GetData();
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    const double x = points->GetComponent(i, 0);
    points->SetComponent(i, 0, x == 0.5 ? 0.95 : x); // the parabola 2.8 x - 1.8 x^2, at most 1.09
  }
  double bounds[6];
  this->Blocks.findBounds(grid, bounds);
  EXPECT_EQ(bounds[1], 1);
  this->cut(grid);
  this->Blocks.findBounds(grid, bounds);
  EXPECT_NEAR(bounds[1], 1.0889, 1e-3);
}

} // namespace
