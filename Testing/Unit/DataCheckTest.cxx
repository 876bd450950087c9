// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with data is found before anything reads it: by block, and by array.
#include "Input/DataCheck.h"
#include "Blocks/DataFaults.h"

#include "UnsoundData.h"

#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

void expectWords(const std::string& error, const UnsoundData& unsound)
{
  for (const std::string& word : unsound.Words)
  {
    EXPECT_NE(error.find(word), std::string::npos) << "'" << word << "' in: " << error;
  }
}

vtkSmartPointer<vtkMultiBlockDataSet> treeOf(const std::vector<vtkDataSet*>& blocks)
{
  auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (vtkDataSet* block : blocks)
  {
    tree->SetBlock(tree->GetNumberOfBlocks(), block);
  }
  return tree;
}
} // namespace

TEST(DataCheck, SoundDataHasNoFault)
{
  EXPECT_EQ(checkData(nullptr), "");
  EXPECT_EQ(checkData(vtkNew<vtkUnstructuredGrid>()), "");
  EXPECT_EQ(checkData(vtkNew<vtkImageData>()), "");
  for (const auto& data : soundData())
  {
    EXPECT_EQ(checkData(data), "") << data->GetClassName();
    EXPECT_TRUE(listFaults(data).empty()) << data->GetClassName();
  }
}

TEST(DataCheck, EachFaultHasItsError)
{
  for (const UnsoundData& unsound : unsoundGeometries())
  {
    SCOPED_TRACE(unsound.Name);
    expectWords(checkData(unsound.Data), unsound);
    EXPECT_EQ(checkBlocks(unsound.Data), checkData(unsound.Data));
    EXPECT_EQ(listFaults(unsound.Data).front(), checkData(unsound.Data));
  }
}

TEST(DataCheck, ArraysAreCheckedByThemselves)
{
  for (const UnsoundData& unsound : unsoundArrays())
  {
    SCOPED_TRACE(unsound.Name);
    EXPECT_EQ(checkData(unsound.Data), "");
    const std::vector<std::string> faults = listFaults(unsound.Data);
    ASSERT_EQ(faults.size(), 1u);
    expectWords(faults[0], unsound);
  }
}

TEST(DataCheck, OfATreeEachBlockIsNamed)
{
  std::vector<UnsoundData> unsound = unsoundGeometries();
  const auto sound = soundData();
  vtkNew<vtkStringArray> words; // is no array of numbers, but is copied with the others
  words->SetName("words");
  words->SetNumberOfValues(3);
  sound[1]->GetPointData()->AddArray(words);
  const auto tree = treeOf({ sound[0], unsound[0].Data, sound[1], unsound[3].Data });
  tree->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "wall");
  const std::vector<std::string> faults = listFaults(tree);
  ASSERT_EQ(faults.size(), 3u);
  EXPECT_EQ(faults[0], "Block \"wall\": " + checkData(unsound[0].Data));
  EXPECT_NE(
    faults[1].find("Block number 3: The scalar array \"words\" has 3 tuples"), std::string::npos)
    << faults[1];
  EXPECT_EQ(faults[2], "Block number 4: " + checkData(unsound[3].Data));
  EXPECT_EQ(checkBlocks(tree), faults[0]);
}

TEST(DataCheck, SlicesAreLeftOutOfTreesOnly)
{
  vtkNew<vtkImageData> slice;
  slice->SetDimensions(5, 5, 1);
  EXPECT_NE(checkBlocks(slice).find("5 x 5 x 1 points"), std::string::npos);
  EXPECT_EQ(checkBlocks(treeOf({ soundData()[0], slice })), "");
}

// Of hexahedra that share points as they like.
TEST(DataCheck, ExplicitStructuredGrids)
{
  vtkNew<vtkExplicitStructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 12; ++i)
  {
    points->InsertNextPoint(i % 3, i / 3 % 2, i / 6);
  }
  grid->SetDimensions(3, 2, 2);
  grid->SetPoints(points);
  const auto setCells = [&grid](vtkIdType last)
  {
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({ 0, 1, 4, 3, 6, 7, 10, 9 });
    cells->InsertNextCell({ 1, 2, 5, 4, 7, 8, last, 10 });
    grid->SetCells(cells);
  };
  setCells(11);
  EXPECT_EQ(checkData(grid), "");
  points->SetPoint(11, 2, std::nan(""), 1);
  EXPECT_NE(checkData(grid).find("Coordinate 1 of point 11, which cell 1 has"), std::string::npos);
  setCells(12);
  EXPECT_NE(checkData(grid).find("cell 1 names point 12"), std::string::npos);
  vtkNew<vtkCellArray> one;
  one->InsertNextCell({ 0, 1, 4, 3, 6, 7, 10, 9 });
  grid->SetCells(one);
  EXPECT_NE(checkData(grid).find("has 1 cells, but its dimensions call for 2"), std::string::npos);
}

// The verdict is kept as long as nothing is said to be modified, and no longer.
TEST(DataCheck, ModifiedGridsAreCheckedAgain)
{
  const auto sound = soundData();
  auto* grid = vtkUnstructuredGrid::SafeDownCast(sound[0]);
  ASSERT_NE(grid, nullptr);
  EXPECT_EQ(checkData(grid), "");
  auto* points = vtkDoubleArray::SafeDownCast(grid->GetPoints()->GetData());
  ASSERT_NE(points, nullptr);
  const double before = points->GetValue(0);
  points->SetValue(0, std::nan(""));
  EXPECT_EQ(checkData(grid), "");
  grid->Modified();
  EXPECT_NE(checkData(grid), "");
  points->SetValue(0, before);
  points->Modified();
  EXPECT_EQ(checkData(grid), "");
}

// Ghost arrays of another type are none to VTK.
TEST(DataCheck, ValuesThatHaveTheNameOfGhostsOnly)
{
  const auto sound = soundData();
  vtkNew<vtkDoubleArray> values;
  values->SetName("vtkGhostType");
  values->SetNumberOfTuples(3);
  sound[2]->GetPointData()->AddArray(values);
  EXPECT_EQ(checkData(sound[2]), "");
  EXPECT_EQ(listFaults(sound[2]).size(), 1u);
}
