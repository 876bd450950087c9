// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Explicit structured grids whose cells share the points of a lattice become curvilinear grids;
// others stay what they are.
#include "Input/ExplicitLattice.h"

#include "CurvilinearGrids.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <vector>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

enum class Numbers
{
  OfLattice,
  Reversed,
  OfEachCell
};

vtkSmartPointer<vtkStructuredGrid> bentGrid()
{
  return curvilinearGrid({ 3, 4, 5 },
    [](const std::array<double, 3>& p) {
      return std::array<double, 3>{ { p[0] + 0.2 * p[1] * p[2], p[1], p[2] - 0.1 * p[0] } };
    });
}

// The same cells, with values of cells and, if asked for, of points: the number of the lattice's
// point.
vtkSmartPointer<vtkExplicitStructuredGrid> explicitOf(
  vtkStructuredGrid* lattice, Numbers numbers, bool valuesOfPoints)
{
  const vtkIdType count = lattice->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> ofPoints;
  ofPoints->SetName("of points");
  const auto add = [&](vtkIdType id)
  {
    ofPoints->InsertNextValue(static_cast<double>(id));
    return points->InsertNextPoint(lattice->GetPoint(id));
  };
  for (vtkIdType i = 0; numbers != Numbers::OfEachCell && i < count; ++i)
  {
    add(numbers == Numbers::Reversed ? count - 1 - i : i);
  }
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("of cells");
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < lattice->GetNumberOfCells(); ++cell)
  {
    lattice->GetCellPoints(cell, ids);
    for (vtkIdType& id : *ids)
    {
      id = numbers == Numbers::OfEachCell ? add(id)
           : numbers == Numbers::Reversed ? count - 1 - id
                                          : id;
    }
    cells->InsertNextCell(ids);
    ofCells->InsertNextValue(static_cast<double>(cell));
  }
  auto grid = vtkSmartPointer<vtkExplicitStructuredGrid>::New();
  int extent[6];
  lattice->GetExtent(extent);
  grid->SetExtent(extent);
  grid->SetPoints(points);
  grid->SetCells(cells);
  grid->GetCellData()->AddArray(ofCells);
  if (valuesOfPoints)
  {
    grid->GetPointData()->AddArray(ofPoints);
  }
  return grid;
}

void movePoint(vtkExplicitStructuredGrid* grid, vtkIdType point)
{
  double* at = grid->GetPoint(point);
  grid->GetPoints()->SetPoint(point, at[0], at[1], at[2] + 0.01);
}

TEST(ExplicitLattice, HasTheCellsThatShareTheirPoints)
{
  const auto lattice = bentGrid();
  for (const Numbers numbers : { Numbers::OfLattice, Numbers::Reversed, Numbers::OfEachCell })
  {
    SCOPED_TRACE(static_cast<int>(numbers));
    const bool ofPoints = numbers != Numbers::OfEachCell;
    const auto grid = explicitOf(lattice, numbers, ofPoints);
    ExplicitLattice made;
    vtkStructuredGrid* found = made.curvilinearOf(grid);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->GetNumberOfPoints(), lattice->GetNumberOfPoints());
    ASSERT_EQ(found->GetNumberOfCells(), lattice->GetNumberOfCells());
    for (vtkIdType i = 0; i < lattice->GetNumberOfPoints(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_EQ(found->GetPoint(i)[k], lattice->GetPoint(i)[k]);
      }
      if (ofPoints)
      {
        EXPECT_EQ(found->GetPointData()->GetArray("of points")->GetTuple1(i), double(i));
      }
    }
    EXPECT_EQ(
      found->GetCellData()->GetArray("of cells"), grid->GetCellData()->GetArray("of cells"));
  }
}

TEST(ExplicitLattice, IsNoneWhereNeighboursHaveOtherPoints)
{
  const auto lattice = bentGrid();
  ExplicitLattice made;
  EXPECT_FALSE(made.curvilinearOf(explicitOf(lattice, Numbers::OfEachCell, true)))
    << "values may jump";
  const auto fault = explicitOf(lattice, Numbers::OfEachCell, false);
  movePoint(fault, fault->GetNumberOfPoints() / 2);
  EXPECT_FALSE(made.curvilinearOf(fault));
  const auto turned = explicitOf(lattice, Numbers::OfLattice, true);
  vtkNew<vtkIdList> ids;
  turned->GetCells()->GetCellAtId(7, ids);
  std::rotate(ids->begin(), ids->begin() + 1, ids->begin() + 4);
  turned->GetCells()->ReplaceCellAtId(7, ids);
  EXPECT_FALSE(made.curvilinearOf(turned)) << "a cell's points are in another order";
  const auto unsound = explicitOf(lattice, Numbers::OfLattice, true);
  ids->SetId(0, unsound->GetNumberOfPoints());
  unsound->GetCells()->ReplaceCellAtId(7, ids);
  EXPECT_FALSE(made.curvilinearOf(unsound)) << "drawing it as cells gives the error";
  EXPECT_FALSE(made.curvilinearOf(vtkNew<vtkExplicitStructuredGrid>())) << "without cells";
  EXPECT_FALSE(made.curvilinearOf(vtkNew<vtkImageData>()));
  EXPECT_FALSE(made.curvilinearOf(nullptr));
  EXPECT_EQ(made.curvilinearOf(lattice), lattice);
}

// So that the mesh stays if only values change.
TEST(ExplicitLattice, KeepsItsPointsAsLongAsTheGridDoes)
{
  const auto grid = explicitOf(bentGrid(), Numbers::Reversed, true);
  ExplicitLattice made;
  vtkPoints* points = made.curvilinearOf(grid)->GetPoints();
  const vtkMTimeType changed = points->GetMTime();
  vtkDataArray* values = grid->GetPointData()->GetArray("of points");
  values->SetTuple1(0, -1.0);
  values->Modified();
  vtkStructuredGrid* again = made.curvilinearOf(grid);
  EXPECT_EQ(
    again->GetPointData()->GetArray("of points")->GetTuple1(again->GetNumberOfPoints() - 1), -1.0);
  EXPECT_EQ(again->GetPoints(), points);
  EXPECT_EQ(again->GetPoints()->GetMTime(), changed);
  movePoint(grid, 0);
  grid->GetPoints()->Modified();
  EXPECT_NE(made.curvilinearOf(grid)->GetPoints()->GetMTime(), changed);
}
} // namespace
