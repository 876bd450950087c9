// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ArraySelection.h"
#include "Failure.h"
#include "TestGrids.h"

#include "vtkIntArray.h"

#include <gtest/gtest.h>

namespace
{
using tetmarch::Association;
using tetmarch::SelectArray;

std::string GetError(
  vtkUnstructuredGrid* grid, const std::string& name, std::optional<Association> where)
{
  try
  {
    SelectArray({ grid }, name, where);
  }
  catch (const tetmarch::Failure& failure)
  {
    return failure.what();
  }
  return "accepted";
}
} // namespace

TEST(ArraySelection, FailuresListWhatThereIs)
{
  auto grid = MakeVoxel(0.0);
  EXPECT_EQ(GetError(grid, "", std::nullopt),
    "the data has no array to draw (on points: none; on cells: none)");
  AddArray<vtkDoubleArray>(grid->GetPointData(), "p", 8);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "U", 8, 3);
  AddArray<vtkDoubleArray>(grid->GetCellData(), "rho", 1);
  EXPECT_EQ(
    GetError(grid, "q", std::nullopt), "there is no array 'q' (on points: p, U; on cells: rho)");
  EXPECT_EQ(GetError(grid, "p", Association::CELLS),
    "there is no array 'p' on cells (on points: p, U; on cells: rho)");
}

TEST(ArraySelection, PrefersVaryingScalarsOnPoints)
{
  auto grid = MakeVoxel(0.0);
  AddArray<vtkIntArray>(grid->GetPointData(), "ids", 8);
  EXPECT_STREQ(SelectArray({ grid }, "", std::nullopt).Array->GetName(), "ids");
  AddArray<vtkDoubleArray>(grid->GetPointData(), "constant", 8, 1, false);
  EXPECT_STREQ(SelectArray({ grid }, "", std::nullopt).Array->GetName(), "ids");
  AddArray<vtkDoubleArray>(grid->GetPointData(), "vector", 8, 3);
  EXPECT_STREQ(SelectArray({ grid }, "", std::nullopt).Array->GetName(), "vector");
  AddArray<vtkDoubleArray>(grid->GetPointData(), "scalar", 8);
  EXPECT_STREQ(SelectArray({ grid }, "", std::nullopt).Array->GetName(), "scalar");
  EXPECT_STREQ(SelectArray({ grid }, "constant", std::nullopt).Array->GetName(), "constant");
}

TEST(ArraySelection, PointsComeBeforeCells)
{
  auto grid = MakeVoxel(0.0);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "s", 8);
  AddArray<vtkDoubleArray>(grid->GetCellData(), "s", 1);
  EXPECT_EQ(SelectArray({ grid }, "s", std::nullopt).Where, Association::POINTS);
  EXPECT_EQ(SelectArray({ grid }, "s", Association::CELLS).Where, Association::CELLS);
  EXPECT_EQ(SelectArray({ grid }, "s", Association::CELLS).Array->GetNumberOfTuples(), 1);
}

TEST(ArraySelection, OfSeveralBlocksTheFirstArrayOfAName)
{
  auto first = MakeVoxel(0.0), second = MakeVoxel(1.0);
  AddArray<vtkDoubleArray>(first->GetPointData(), "p", 8);
  AddArray<vtkDoubleArray>(second->GetPointData(), "p", 8);
  AddArray<vtkDoubleArray>(second->GetPointData(), "q", 8);
  second->GetPointData()->GetArray("p")->SetComponent(3, 0, -20.0);
  EXPECT_EQ(
    SelectArray({ first, second }, "p", std::nullopt).Array, first->GetPointData()->GetArray("p"));
  const auto selection = SelectArray({ second, first }, "p", std::nullopt);
  EXPECT_EQ(selection.Array, second->GetPointData()->GetArray("p"));
  EXPECT_EQ(tetmarch::FindArray(first, selection), first->GetPointData()->GetArray("p"));
  EXPECT_EQ(
    tetmarch::GetRange({ first, second }, selection), (std::array<double, 2>{ { -20.0, 7.0 } }));
  const auto q = SelectArray({ first, second }, "q", std::nullopt);
  EXPECT_EQ(tetmarch::FindArray(first, q), nullptr);
  EXPECT_EQ(tetmarch::GetRange({ first, second }, q), (std::array<double, 2>{ { 0.0, 7.0 } }));
}
