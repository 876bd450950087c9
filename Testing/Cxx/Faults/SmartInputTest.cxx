// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Structured data that can't be drawn are one error with what is wrong and what helps, and leave no
// trace when they are put right.
#include "ErrorScene.h"
#include "SmartScene.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
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
  void expectNothingOf(vtkDataObject* data)
  {
    this->show(data);
    this->expectEmptyWithoutErrors();
    this->showSound();
    this->expectSound();
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

TEST_F(SmartInput, EmptyDataIsNoError)
{
  this->expectNothingOf(vtkNew<vtkImageData>());
  this->expectNothingOf(vtkNew<vtkRectilinearGrid>());
  this->expectNothingOf(vtkNew<vtkMultiBlockDataSet>());
}

TEST_F(SmartInput, FlatData)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    ImagePlace place = unitCube(6);
    place.Extent[2 * axis + 1] = 0;
    this->expectErrorOf(imageOf(sineField(), place), { "image", "7" });
  }
  ImagePlace line = unitCube(6);
  line.Extent = { { 0, 0, 0, 0, 0, 6 } };
  this->expectErrorOf(imageOf(sineField(), line), { "1 x 1 x 7" });
}

TEST_F(SmartInput, NoScalars)
{
  const auto image = imageOf(sineField(), unitCube(6));
  image->GetPointData()->SetActiveScalars(nullptr);
  image->GetCellData()->SetActiveScalars(nullptr);
  this->expectErrorOf(
    image, { "no active scalars", "Point arrays: f", "cell arrays: c", "SelectScalarArray" });
}

TEST_F(SmartInput, ArraysThatAreNotThere)
{
  this->expectErrorOfArray(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, "temperature",
    { "\"temperature\"", "in the point data", "f" });
  this->expectErrorOfArray(
    VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, 7, { "number 7", "in the cell data" });
  this->expectErrorOfArray(VTK_SCALAR_MODE_USE_FIELD_DATA, "f", { "Field data" });
}

TEST_F(SmartInput, ArraysOfAnotherLength)
{
  const auto image = imageOf(sineField(), unitCube(6));
  vtkNew<vtkDoubleArray> brief;
  brief->SetName("f");
  brief->SetNumberOfValues(5);
  brief->Fill(0.5);
  image->GetPointData()->SetScalars(brief);
  this->expectErrorOf(image, { "\"f\"", "5", "343" });
}

TEST_F(SmartInput, ComponentsThatAreNotThere)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  this->expectError(
    [mapper]
    {
      mapper->SetVectorMode(vtkSmartVolumeMapper::COMPONENT);
      mapper->SetVectorComponent(2);
    },
    [mapper] { mapper->SetVectorMode(vtkSmartVolumeMapper::DISABLED); },
    { "no component 2", "VectorComponent" });
}

// Of dependent components none is chosen, as by vtkSmartVolumeMapper, and there are no three of
// them.
TEST_F(SmartInput, ThreeDependentComponents)
{
  const auto image = imageOf(sineField(), unitCube(6));
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("v");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(image->GetNumberOfPoints());
  vectors->Fill(0.5);
  image->GetPointData()->SetScalars(vectors);
  this->Shown.Mapper->SetVectorMode(vtkSmartVolumeMapper::COMPONENT);
  this->Shown.property()->IndependentComponentsOff();
  this->expectErrorOf(image, { "has 3 components", "IndependentComponents on", "VectorMode" });
}

TEST_F(SmartInput, UnstructuredGrids)
{
  this->expectErrorOf(jitteredLattice(2, 0.1, 1, sineField()),
    { "The input is a vtkUnstructuredGrid", "vtkTetMarchVolumeMapper" });
}

TEST_F(SmartInput, NothingButUnstructuredBlocks)
{
  vtkNew<vtkMultiBlockDataSet> tree;
  tree->SetBlock(0, jitteredLattice(2, 0.1, 1, sineField()));
  tree->SetBlock(1, vtkNew<vtkPolyData>());
  tree->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "wing");
  this->expectErrorOf(
    tree, { "Block \"wing\"", "vtkUnstructuredGrid", "vtkTetMarchVolumeMapper", "No other block" });
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

TEST_F(SmartInput, PlacesThatAreNone)
{
  const auto image = imageOf(sineField(), unitCube(6));
  image->SetSpacing(0.1, 0.0, 0.1);
  this->expectErrorOf(image, { "spacing" });
  const auto grid = rectilinearOf(sineField(), unevenCube(6));
  grid->GetYCoordinates()->SetComponent(3, 0, grid->GetYCoordinates()->GetComponent(2, 0));
  this->expectErrorOf(grid, { "y coordinate", "ascend" });
}

TEST_F(SmartInput, BlendModesThatThereAreNot)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  this->expectError([mapper] { mapper->SetBlendMode(99); },
    [mapper] { mapper->SetBlendModeToComposite(); }, { "blend mode" });
}

// A lattice has no boundary faces to be shown. What the message names draws.
TEST_F(SmartInput, ViewsOfBoundaryFaces)
{
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  for (int mode :
    { vtkTetMarchSettings::VIEW_BOUNDARY_FACES, vtkTetMarchSettings::VIEW_BOUNDARY_COORDINATES })
  {
    const auto mend = [mapper] { mapper->SetViewModeToPicture(); };
    this->expectError([=] { mapper->SetViewMode(mode); }, mend,
      { "boundary faces", "has none", "SetViewModeToCells()" });
  }
  const ErrorWatch watch(mapper);
  mapper->SetViewModeToBoundaryFaces();
  this->expectEmpty();
  EXPECT_EQ(mapper->GetNumberOfDraws(), 0);
  mapper->SetViewModeToCells();
  EXPECT_GT(compare(this->Shown.frame(), this->Empty).Max, 0.1);
  EXPECT_EQ(watch.Errors.size(), 1u);
}

// A uniform grid is an image with hidden cells: without all of its cells nothing is left.
TEST_F(SmartInput, AGridOfHiddenCells)
{
  const auto image = imageOf(sineField(), unitCube(6));
  markCells(image, vtkDataSetAttributes::HIDDENCELL, [](vtkIdType) { return true; });
  this->show(image);
  this->expectNothingVisible();
  vtkNew<vtkUniformGrid> grid;
  grid->ShallowCopy(this->Shown.Data);
  this->expectDrawnWithoutErrors(grid);
}
} // namespace
