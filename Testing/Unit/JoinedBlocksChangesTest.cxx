// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which blocks are joined, the errors about others, and what is made again after which change.
#include "Grids.h"
#include "JoinedGrids.h"
#include "ScarceMemory.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

TEST_F(Joined, BlocksWithoutTheArrayAreNamed)
{
  const std::vector<Grid> cut = cutIntoBlocks(jitteredLattice(4), partsOfUnitCube(8));
  cut[3]->GetPointData()->RemoveArray("f");
  vtkNew<vtkDoubleArray> pairs;
  pairs->SetName("f");
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(cut[6]->GetNumberOfPoints());
  cut[6]->GetPointData()->AddArray(pairs);
  this->Input = blocks(cut);
  this->Input->GetMetaData(3u)->Set(vtkCompositeDataSet::NAME(), "wing");
  EXPECT_EQ(this->Blocks.update(this->Input, pointArray("f")), "");
  EXPECT_EQ(this->grid()->GetNumberOfCells(), 6 * 48);
  for (const char* word : { "array named \"f\" in the point data", "\"wing\"", "number 7" })
  {
    EXPECT_NE(this->Blocks.omissions().find(word), std::string::npos) << this->Blocks.omissions();
  }
  EXPECT_EQ(this->Blocks.update(this->Input, cellArray("c")), "");
  EXPECT_EQ(this->grid()->GetNumberOfCells(), 8 * 48);
  EXPECT_EQ(this->Blocks.omissions(), "");
}

TEST_F(Joined, BlocksOfPointAndOfCellScalarsDontMix)
{
  const std::vector<Grid> cut = cutIntoBlocks(jitteredLattice(4), partsOfUnitCube(2));
  cut[1]->GetPointData()->Initialize();
  this->join(cut); // by default: point scalars, or cell scalars where there are none
  EXPECT_FALSE(this->Blocks.hasCellScalars());
  EXPECT_EQ(this->grid()->GetNumberOfCells(), 192);
  EXPECT_NE(this->Blocks.omissions().find("number 2"), std::string::npos);
}

TEST_F(Joined, ErrorsNameTheBlock)
{
  const auto errorOf = [this](const std::vector<Grid>& cut, const ScalarSelection& selection)
  {
    this->Input = blocks(cut);
    const std::string error = this->Blocks.update(this->Input, selection);
    EXPECT_EQ(this->grid(), nullptr);
    EXPECT_EQ(this->Blocks.update(this->Input, selection), error); // as long as nothing changes
    return error;
  };
  std::vector<Grid> cut = cutIntoBlocks(jitteredLattice(4), partsOfUnitCube(2));
  std::string error = errorOf(cut, pointArray("g"));
  EXPECT_NE(error.find("No block has array named \"g\""), std::string::npos) << error;
  EXPECT_NE(error.find("Point arrays: f; cell arrays: c"), std::string::npos) << error;
  cut[1]->GetPointData()->GetScalars()->SetNumberOfTuples(3);
  error = errorOf(cut, ActiveScalars);
  EXPECT_NE(error.find("Block number 2: The scalar array"), std::string::npos) << error;
  cut = cutIntoBlocks(jitteredLattice(4), partsOfUnitCube(2));
  const vtkIdType corners[4] = { 0, 1, 2, 4711 };
  cut[1]->InsertNextCell(VTK_TETRA, 4, corners);
  error = errorOf(cut, ActiveScalars);
  EXPECT_NE(error.find("Block number 2: The connectivity"), std::string::npos) << error;
  this->join(cutIntoBlocks(jitteredLattice(4), partsOfUnitCube(2)));
  EXPECT_EQ(this->grid()->GetNumberOfPoints(), 125);
}

TEST_F(Joined, OnlyWhatChangedIsJoinedAgain)
{
  const std::vector<Grid> cut = cutIntoBlocks(jitteredLattice(4), partsOfUnitCube(2));
  this->join(cut);
  EXPECT_EQ(this->Blocks.record().Runs, 1);
  vtkUnstructuredGrid* before = this->grid();
  const vtkMTimeType points = before->GetPoints()->GetMTime();
  this->Blocks.update(this->Input, ActiveScalars);
  EXPECT_EQ(this->Blocks.record().Runs, 1);
  // Scalars alone; in a tree of other objects with the same arrays, as a pipeline hands on.
  const auto fill = [](vtkUnstructuredGrid* block, double value)
  {
    block->GetPointData()->GetScalars()->Fill(value);
    block->GetPointData()->GetScalars()->Modified();
  };
  fill(cut[0], 0.75);
  fill(cut[1], 0.75);
  vtkNew<vtkMultiBlockDataSet> copy;
  copy->ShallowCopy(this->Input);
  EXPECT_EQ(this->Blocks.update(copy, ActiveScalars), "");
  EXPECT_EQ(this->Blocks.record().Runs, 2);
  EXPECT_EQ(this->grid(), before);
  EXPECT_EQ(this->grid()->GetPoints()->GetMTime(), points);
  EXPECT_EQ(this->Blocks.scalars()->GetRange()[0], 0.75);
  EXPECT_EQ(this->Blocks.scalars()->GetRange()[1], 0.75);
  // Scalars that jump from block to block.
  fill(cut[1], 0.5);
  this->Blocks.update(this->Input, ActiveScalars);
  EXPECT_EQ(this->Blocks.record().Runs, 3);
  EXPECT_EQ(this->grid()->GetNumberOfPoints(), 125 + 25);
  // A block that moves.
  cut[1]->GetPoints()->SetPoint(4, 0.7, 0.1, 0.1);
  cut[1]->GetPoints()->Modified();
  this->Blocks.update(this->Input, ActiveScalars);
  EXPECT_EQ(this->Blocks.record().Runs, 4);
  EXPECT_NE(this->grid()->GetPoints()->GetMTime(), points);
  // A block fewer.
  this->Input->SetBlock(0, nullptr);
  this->Blocks.update(this->Input, ActiveScalars);
  EXPECT_EQ(this->grid()->GetNumberOfCells(), 192);
  EXPECT_EQ(this->Blocks.record().Runs, 5);
}

TEST_F(Joined, ASingleBlockIsTakenAsItIs)
{
  const Grid grid = jitteredLattice(3);
  this->join({ grid });
  EXPECT_EQ(this->grid(), grid);
  EXPECT_EQ(this->Blocks.scalars(), grid->GetPointData()->GetScalars());
  vtkNew<vtkMultiBlockDataSet> copy;
  copy->ShallowCopy(this->Input);
  vtkNew<vtkUnstructuredGrid> other;
  other->ShallowCopy(grid);
  vtkNew<vtkDoubleArray> scalars;
  scalars->DeepCopy(grid->GetPointData()->GetScalars());
  other->GetPointData()->SetScalars(scalars);
  copy->SetBlock(0, other);
  EXPECT_EQ(this->Blocks.update(copy, ActiveScalars), "");
  EXPECT_EQ(this->grid(), other);
  EXPECT_EQ(this->Blocks.scalars(), scalars);
}

TEST_F(Joined, TooLittleMemory)
{
  this->Input = blocks(cutIntoBlocks(jitteredLattice(6), partsOfUnitCube(2)));
  // Of an exception in another thread VTK's own pool of threads would die.
  const std::string before = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential");
  int failures = 0;
  vtkObject::GlobalWarningDisplayOff(); // VTK complains of objects whose constructors throw
  for (int i = 0; failures == i; ++i)
  {
    std::string error;
    {
      const ScarceMemory scarce(1024, i); // less is what VTK needs to free what it has
      error = this->Blocks.update(this->Input, ActiveScalars);
    }
    if (!error.empty())
    {
      ++failures;
      EXPECT_NE(error.find("too little memory for joining the blocks"), std::string::npos) << error;
      EXPECT_EQ(this->grid(), nullptr);
    }
  }
  vtkObject::GlobalWarningDisplayOn();
  vtkSMPTools::SetBackend(before.c_str());
  EXPECT_GT(failures, 3);
  EXPECT_EQ(this->grid()->GetNumberOfPoints(), 343);
}
} // namespace
