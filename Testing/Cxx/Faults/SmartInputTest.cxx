// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Input of images without an error: none, uniform grids, and trees that contain other data, too.
#include "ErrorScene.h"
#include "SmartScene.h"

#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkUniformGrid.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

class SmartInput : public ErrorsIn<SmartScene>
{
protected:
  SmartInput()
    : ErrorsIn(imageOf(sineField(), unitCube(6)))
  {
  }

  void expectDrawnWithoutErrors(vtkDataObject* data)
  {
    const ErrorWatch watch(this->Shown.Mapper);
    this->show(data);
    this->expectSound();
    EXPECT_EQ(watch.Errors, Words());
  }
};

TEST_F(SmartInput, NoneIsNoError)
{
  const ErrorWatch watch(this->Shown.Mapper);
  this->Shown.Mapper->RemoveAllInputs();
  this->Shown.Mapper->Render(this->Shown.Renderer, this->Shown.Volume);
  EXPECT_EQ(watch.Errors, Words());
  EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), 0) << "nothing is kept of data that is gone";
}

// In a mixed tree images are drawn as without the others, which one warning counts.
TEST_F(SmartInput, UnstructuredBlocksAmongImages)
{
  vtkNew<vtkMultiBlockDataSet> tree;
  tree->SetBlock(0, jitteredLattice(2, 0.1, 1, sineField()));
  tree->SetBlock(1, this->Shown.Data);
  tree->SetBlock(2, jitteredLattice(3, 0.1, 1, sineField()));
  tree->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "wing");
  const ErrorWatch watch(this->Shown.Mapper);
  this->show(tree);
  for (int i = 0; i < 3; ++i)
  {
    this->expectSound();
  }
  EXPECT_EQ(watch.Errors, Words());
  ASSERT_EQ(watch.Warnings.size(), 1u);
  for (const char* word : { "2 blocks", "\"wing\"", "vtkUnstructuredGrid", "TetMarchVolumeMapper" })
  {
    EXPECT_NE(watch.Warnings[0].find(word), std::string::npos) << watch.Warnings[0];
  }
  EXPECT_TRUE(
    this->Shown.Mapper->Pick(this->Shown.Renderer, this->Shown.Volume, Side / 2, Side / 2));
  EXPECT_EQ(this->Shown.Mapper->GetPickedBlock(), 2u);
  tree->SetBlock(0, nullptr);
  tree->SetBlock(2, nullptr);
  this->expectSound();
  EXPECT_EQ(watch.Warnings.size(), 1u);
}

// Surfaces beside the blocks are no volume, and no error.
TEST_F(SmartInput, SurfacesAmongTheBlocks)
{
  vtkNew<vtkMultiBlockDataSet> tree;
  tree->SetBlock(0, vtkNew<vtkPolyData>());
  tree->SetBlock(1, this->Shown.Data);
  this->expectDrawnWithoutErrors(tree);
}

// A uniform grid is an image.
TEST_F(SmartInput, AUniformGrid)
{
  vtkNew<vtkUniformGrid> grid;
  grid->ShallowCopy(this->Shown.Data);
  this->expectDrawnWithoutErrors(grid);
}

// A lattice has no boundary faces to be shown. What the message names draws.
TEST_F(SmartInput, ViewsOfCellsInsteadOfBoundaryFaces)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  const ErrorWatch watch(mapper);
  mapper->SetViewModeToBoundaryFaces();
  this->expectEmpty();
  EXPECT_EQ(mapper->GetNumberOfDraws(), 0);
  mapper->SetViewModeToCells();
  EXPECT_GT(compare(this->Shown.frame(), this->Empty).Max, 0.1);
  EXPECT_EQ(watch.Errors.size(), 1u);
}
} // namespace
