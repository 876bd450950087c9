// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/ArrayChoice.h"
#include "FirstPicture/ArrayTable.h"

#include "TestGrids.h"

#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace
{
using namespace tetmarch;

std::string errorOf(vtkUnstructuredGrid* grid, const std::string& name, std::optional<bool> ofCells)
{
  DrawnArray chosen;
  return chooseArray({ grid }, { name, ofCells, std::nullopt }, chosen);
}

DrawnArray choose(const std::vector<vtkDataSet*>& blocks, const std::string& name,
  std::optional<bool> ofCells = std::nullopt)
{
  DrawnArray chosen;
  EXPECT_EQ(chooseArray(blocks, { name, ofCells, std::nullopt }, chosen), "");
  return chosen;
}
} // namespace

TEST(ArrayChoice, FailuresListWhatThereIs)
{
  auto grid = MakeVoxel(0.0);
  EXPECT_EQ(errorOf(grid, "", std::nullopt),
    "the data has no array to draw (on points: none; on cells: none)");
  AddArray<vtkDoubleArray>(grid->GetPointData(), "p", 8);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "U", 8, 3);
  AddArray<vtkDoubleArray>(grid->GetCellData(), "rho", 1);
  EXPECT_EQ(
    errorOf(grid, "q", std::nullopt), "there is no array 'q' (on points: p, U; on cells: rho)");
  EXPECT_EQ(
    errorOf(grid, "p", true), "there is no array 'p' on cells (on points: p, U; on cells: rho)");
}

TEST(ArrayChoice, PrefersVaryingScalarsOnPoints)
{
  auto grid = MakeVoxel(0.0);
  AddArray<vtkIntArray>(grid->GetPointData(), "counts", 8);
  EXPECT_STREQ(choose({ grid }, "").Array->GetName(), "counts");
  AddArray<vtkDoubleArray>(grid->GetPointData(), "constant", 8, 1, false);
  EXPECT_STREQ(choose({ grid }, "").Array->GetName(), "counts");
  AddArray<vtkDoubleArray>(grid->GetPointData(), "vector", 8, 3);
  EXPECT_STREQ(choose({ grid }, "").Array->GetName(), "vector");
  AddArray<vtkDoubleArray>(grid->GetPointData(), "scalar", 8);
  EXPECT_STREQ(choose({ grid }, "").Array->GetName(), "scalar");
  EXPECT_STREQ(choose({ grid }, "constant").Array->GetName(), "constant");
}

TEST(ArrayChoice, PointsComeBeforeCells)
{
  auto grid = MakeVoxel(0.0);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "s", 8);
  AddArray<vtkDoubleArray>(grid->GetCellData(), "s", 1);
  EXPECT_FALSE(choose({ grid }, "s").OfCells);
  EXPECT_TRUE(choose({ grid }, "s", true).OfCells);
  EXPECT_EQ(choose({ grid }, "s", true).Array->GetNumberOfTuples(), 1);
}

TEST(ArrayChoice, OfSeveralBlocksTheFirstArrayOfAName)
{
  auto first = MakeVoxel(0.0), second = MakeVoxel(1.0);
  AddArray<vtkDoubleArray>(first->GetPointData(), "p", 8);
  AddArray<vtkDoubleArray>(second->GetPointData(), "p", 8);
  AddArray<vtkDoubleArray>(second->GetPointData(), "q", 8);
  second->GetPointData()->GetArray("p")->SetComponent(3, 0, -20.0);
  EXPECT_EQ(choose({ first, second }, "p").Array, first->GetPointData()->GetArray("p"));
  const DrawnArray p = choose({ second, first }, "p");
  EXPECT_EQ(p.Array, second->GetPointData()->GetArray("p"));
  EXPECT_TRUE(bool(DrawnValues(first, p)));
  EXPECT_EQ(rangeOf({ first, second }, p), (std::array<double, 2>{ { -20.0, 7.0 } }));
  const DrawnArray q = choose({ first, second }, "q");
  EXPECT_FALSE(bool(DrawnValues(first, q)));
  EXPECT_EQ(rangeOf({ first, second }, q), (std::array<double, 2>{ { 0.0, 7.0 } }));
}

TEST(ArrayChoice, CellsOfAllBlocksComeBeforePointsOfSome)
{
  auto first = MakeVoxel(0.0), second = MakeVoxel(1.0);
  for (auto* block : { first.Get(), second.Get() })
  {
    AddArray<vtkDoubleArray>(block->GetCellData(), "s", 1);
  }
  AddArray<vtkDoubleArray>(first->GetPointData(), "s", 8);
  EXPECT_TRUE(choose({ first, second }, "s").OfCells);
  EXPECT_FALSE(choose({ first, second }, "s", false).OfCells);
  EXPECT_FALSE(choose({ first }, "s").OfCells);
  AddArray<vtkDoubleArray>(second->GetPointData(), "s", 8);
  EXPECT_FALSE(choose({ first, second }, "s").OfCells);
}

// Blocks without the array are not drawn.
TEST(ArrayChoice, WhatAllBlocksHaveComesFirst)
{
  auto first = MakeVoxel(0.0), second = MakeVoxel(1.0);
  AddArray<vtkDoubleArray>(first->GetPointData(), "of one", 8);
  AddArray<vtkDoubleArray>(first->GetPointData(), "other components", 8);
  AddArray<vtkIntArray>(first->GetPointData(), "material", 8);
  AddArray<vtkDoubleArray>(second->GetPointData(), "other components", 8, 3);
  AddArray<vtkIntArray>(second->GetPointData(), "material", 8);
  first->GetPointData()->SetActiveScalars("of one");
  EXPECT_STREQ(choose({ first, second }, "").Array->GetName(), "material");
  EXPECT_STREQ(choose({ second, first }, "").Array->GetName(), "material");
  EXPECT_STREQ(choose({ first, second }, "of one").Array->GetName(), "of one");
  AddArray<vtkDoubleArray>(first->GetCellData(), "s", 1);
  AddArray<vtkDoubleArray>(second->GetCellData(), "s", 1);
  second->GetCellData()->GetArray("s")->SetComponent(0, 0, 0.5);
  EXPECT_STREQ(choose({ first, second }, "").Array->GetName(), "s");
}

// The first block's alone are all whole.
TEST(ArrayChoice, TheKindIsThatOfTheValuesOfAllBlocks)
{
  auto first = MakeVoxel(0.0), second = MakeVoxel(1.0);
  for (auto* block : { first.Get(), second.Get() })
  {
    AddArray<vtkDoubleArray>(block->GetPointData(), "index", 8);
    AddArray<vtkDoubleArray>(block->GetCellData(), "s", 1);
  }
  second->GetCellData()->GetArray("s")->SetComponent(0, 0, 0.5);
  EXPECT_STREQ(choose({ first, second }, "").Array->GetName(), "s");
  second->GetPointData()->GetArray("index")->SetComponent(0, 0, 0.5);
  EXPECT_STREQ(choose({ first, second }, "").Array->GetName(), "index");
}

TEST(ArrayChoice, NumbersComeAfterValuesAndBeforeConstants)
{
  auto grid = MakeVoxel(0.0);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "constant", 8, 1, false);
  AddArray<vtkIdTypeArray>(grid->GetPointData(), "vtkOriginalPointIds", 8);
  AddArray<vtkDoubleArray>(grid->GetCellData(), "rho", 1);
  EXPECT_STREQ(choose({ grid }, "").Array->GetName(), "vtkOriginalPointIds");
  EXPECT_STREQ(choose({ grid }, "constant").Array->GetName(), "constant");
  auto two = MakeTwoVoxels();
  AddArray<vtkIdTypeArray>(two->GetPointData(), "vtkOriginalPointIds", two->GetNumberOfPoints());
  AddArray<vtkDoubleArray>(two->GetCellData(), "rho", 2);
  EXPECT_STREQ(choose({ two }, "").Array->GetName(), "rho");
  EXPECT_STREQ(choose({ two }, "vtkOriginalPointIds").Array->GetName(), "vtkOriginalPointIds");
}

TEST(ArrayChoice, TheScalarsOfTheDataComeFirstAmongEquals)
{
  auto grid = MakeVoxel(0.0);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "a", 8);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "b", 8);
  EXPECT_STREQ(choose({ grid }, "").Array->GetName(), "a");
  grid->GetPointData()->SetActiveScalars("b");
  EXPECT_STREQ(choose({ grid }, "").Array->GetName(), "b");
}

TEST(ArrayChoice, OfSeveralComponentsTheMagnitudeUnlessAskedFor)
{
  auto grid = MakeVoxel(0.0);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "U", 8, 3);
  EXPECT_EQ(choose({ grid }, "").Component, -1);
  EXPECT_EQ(choose({ grid }, "U").Component, 0);
  DrawnArray chosen;
  EXPECT_EQ(chooseArray({ grid }, { "U", std::nullopt, 2 }, chosen), "");
  EXPECT_EQ(chosen.Component, 2);
  EXPECT_EQ(chooseArray({ grid }, { "U", std::nullopt, 3 }, chosen),
    "array 'U' has no component 3: it has 3, counted from 0");
}

TEST(ArrayChoice, NamesOfNumbers)
{
  for (const char* name : { "vtkOriginalCellIds", "GlobalNodeId", "block_id", "cellids", "ObjectId",
         "material", "MaterialNumber", "PROC_RANK", "region2", "NodeID", "Material Ids" })
  {
    EXPECT_TRUE(namesNumbers(name)) << name;
  }
  for (const char* name :
    { "fluid", "grid", "Solid", "temperature", "k", "density_of_material_a", "acid", "", "7" })
  {
    EXPECT_FALSE(namesNumbers(name)) << name;
  }
}

// Whatever its name: as many different whole values as there are cells.
TEST(ArrayChoice, WholeValuesThatAllDifferAreNumbers)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 100; ++i)
  {
    points->InsertNextPoint(i, 0, 0);
  }
  grid->SetPoints(points);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "order", 100);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "counts", 100);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "p", 100);
  for (int i = 0; i < 100; ++i)
  {
    grid->GetPointData()->GetArray("counts")->SetComponent(i, 0, i % 10);
    grid->GetPointData()->GetArray("p")->SetComponent(i, 0, i + 0.5);
  }
  std::map<std::string, ArrayKind> kinds;
  for (const FoundArray& found : findArrays({ grid }))
  {
    kinds[found.Drawn.Array->GetName()] = found.Kind;
  }
  EXPECT_EQ(kinds["order"], ArrayKind::Numbers);
  EXPECT_EQ(kinds["counts"], ArrayKind::Physical);
  EXPECT_EQ(kinds["p"], ArrayKind::Physical);
}

TEST(ArrayChoice, ArraysThatDoNotFitAreNoneToChooseFrom)
{
  auto first = MakeVoxel(0.0), second = MakeVoxel(1.0);
  AddArray<vtkDoubleArray>(first->GetPointData(), "p", 8);
  AddArray<vtkDoubleArray>(second->GetPointData(), "p", 5); // fits in one block only
  AddArray<vtkDoubleArray>(second->GetPointData(), "q", 8);
  EXPECT_STREQ(choose({ first, second }, "").Array->GetName(), "q");
  EXPECT_EQ(findArrays({ first, second }).size(), 1u);
  EXPECT_STREQ(choose({ first }, "").Array->GetName(), "p");
  const std::string wrong = "The scalar array \"p\" has 5 tuples, but the grid has 8 points.";
  EXPECT_EQ(errorOf(second, "p", std::nullopt), wrong);
  second->GetPointData()->RemoveArray("q");
  EXPECT_EQ(errorOf(second, "", std::nullopt), wrong);
  EXPECT_NE(errorOf(second, "p", true).find("there is no array 'p' on cells"), std::string::npos);
}

TEST(ArrayChoice, WithoutAFiniteValueComesLast)
{
  auto grid = MakeVoxel(0.0);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "nothing", 8);
  AddArray<vtkDoubleArray>(grid->GetCellData(), "constant", 1, 1, false);
  grid->GetPointData()->GetArray("nothing")->Fill(std::nan(""));
  EXPECT_STREQ(choose({ grid }, "").Array->GetName(), "constant");
  const DrawnArray nothing = choose({ grid }, "nothing");
  EXPECT_EQ(rangeOf({ grid }, nothing), std::nullopt);
  EXPECT_EQ(describe({ grid }, nothing), "nothing on points, no value is finite");
  EXPECT_EQ(findArrays({ grid })[0].Kind, ArrayKind::NotFinite);
}

TEST(ArrayChoice, RangesAtTheEndsOfDoublePrecision)
{
  constexpr double most = std::numeric_limits<double>::max();
  auto grid = MakeVoxel(0.0);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "p", 8);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "U", 8, 3);
  vtkDataArray* p = grid->GetPointData()->GetArray("p");
  vtkDataArray* u = grid->GetPointData()->GetArray("U");
  const auto expectRange = [&grid](const char* name, int component, double low, double high)
  {
    DrawnArray drawn = choose({ grid }, name);
    drawn.Component = component;
    const auto range = rangeOf({ grid }, drawn);
    ASSERT_TRUE(range);
    EXPECT_NEAR((*range)[0] / low, 1, 1e-14);
    EXPECT_NEAR((*range)[1] / high, 1, 1e-14);
  };
  p->Fill(0.5 * most);
  p->SetComponent(3, 0, most);
  p->Modified();
  expectRange("p", 0, 0.5 * most, most);
  for (const double unit : { 1e-200, 1e200 })
  {
    u->Fill(0);
    for (vtkIdType i = 0; i < 8; ++i)
    {
      u->SetTuple3(i, 3 * unit, 4 * unit, i == 5 ? 12 * unit : 0);
    }
    u->Modified();
    expectRange("U", -1, 5 * unit, 13 * unit);
  }
  u->SetTuple3(0, most, most, most);
  u->Modified();
  expectRange("U", -1, 5e200, most);
}
