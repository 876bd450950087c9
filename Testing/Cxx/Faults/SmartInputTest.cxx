// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Structured data that can't be drawn are one error with what is wrong and what helps, and leave no
// trace when they are put right.
#include "ErrorWatch.h"
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

#include <functional>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using Words = std::vector<std::string>;

class SmartInput : public testing::Test
{
protected:
  SmartInput()
  {
    this->Shown.Renderer->SetBackground(0.2, 0.4, 0.6);
    this->Sound = this->Shown.frame();
    this->Shown.Volume->VisibilityOff();
    this->Empty = this->Shown.frame();
    this->Shown.Volume->VisibilityOn();
    EXPECT_GT(compare(this->Sound, this->Empty).Max, 0.1);
  }

  void show(vtkDataObject* data) { this->Shown.Mapper->SetInputDataObject(data); }
  void expectEmpty() { EXPECT_EQ(compare(this->Shown.frame(), this->Empty).Max, 0.0); }
  void expectSound() { EXPECT_EQ(compare(this->Shown.frame(), this->Sound).Max, 0.0); }

  void expectError(
    const std::function<void()>& spoil, const std::function<void()>& mend, const Words& words)
  {
    const ErrorWatch watch(this->Shown.Mapper);
    for (std::size_t round = 1; round <= 2; ++round)
    {
      spoil();
      for (int i = 0; i < 3; ++i)
      {
        this->expectEmpty();
        ASSERT_EQ(watch.Errors.size(), round);
      }
      for (const std::string& word : words)
      {
        EXPECT_NE(watch.Errors.back().find(word), std::string::npos)
          << '"' << word << "\" is not in: " << watch.Errors.back();
      }
      mend();
      this->expectSound();
      EXPECT_EQ(watch.Errors.size(), round);
    }
  }
  void expectErrorOf(vtkDataObject* data, const Words& words)
  {
    this->expectError([=] { this->show(data); }, [this] { this->show(this->Shown.Data); }, words);
  }
  void expectEmptyWithoutErrors(vtkDataObject* data)
  {
    const ErrorWatch watch(this->Shown.Mapper);
    this->show(data);
    this->expectEmpty();
    EXPECT_EQ(watch.Errors, Words());
    EXPECT_EQ(watch.Warnings, Words());
    this->show(this->Shown.Data);
    this->expectSound();
  }

  SmartScene Shown{ imageOf(sineField(), unitCube(6)), 64, 64 };
  Image Sound;
  Image Empty;
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
  this->expectEmptyWithoutErrors(vtkNew<vtkImageData>());
  this->expectEmptyWithoutErrors(vtkNew<vtkRectilinearGrid>());
  this->expectEmptyWithoutErrors(vtkNew<vtkMultiBlockDataSet>());
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
  vtkTetMarchSmartVolumeMapper* mapper = this->Shown.Mapper;
  const auto mend = [mapper] { mapper->SetScalarModeToDefault(); };
  this->expectError(
    [mapper]
    {
      mapper->SetScalarModeToUsePointFieldData();
      mapper->SelectScalarArray("temperature");
    },
    mend, { "\"temperature\"", "in the point data", "f" });
  this->expectError(
    [mapper]
    {
      mapper->SetScalarModeToUseCellFieldData();
      mapper->SelectScalarArray(7);
    },
    mend, { "number 7", "in the cell data" });
  this->expectError(
    [mapper]
    {
      mapper->SetScalarMode(VTK_SCALAR_MODE_USE_FIELD_DATA);
      mapper->SelectScalarArray("f");
    },
    mend, { "Field data" });
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

TEST_F(SmartInput, UnstructuredGrids)
{
  this->expectErrorOf(jitteredLattice(2, 0.1, 1, sineField()),
    { "The input is a vtkUnstructuredGrid", "vtkTetMarchVolumeMapper" });
}

TEST_F(SmartInput, UnstructuredBlocks)
{
  vtkNew<vtkMultiBlockDataSet> tree;
  tree->SetBlock(0, this->Shown.Data);
  tree->SetBlock(1, jitteredLattice(2, 0.1, 1, sineField()));
  tree->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "wing");
  this->expectErrorOf(tree, { "Block \"wing\"", "vtkUnstructuredGrid", "vtkTetMarchVolumeMapper" });
}

// Surfaces beside the blocks are no volume, and no error.
TEST_F(SmartInput, SurfacesAmongTheBlocks)
{
  vtkNew<vtkMultiBlockDataSet> tree;
  tree->SetBlock(0, vtkNew<vtkPolyData>());
  tree->SetBlock(1, this->Shown.Data);
  const ErrorWatch watch(this->Shown.Mapper);
  this->show(tree);
  this->expectSound();
  EXPECT_EQ(watch.Errors, Words());
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

// A uniform grid is an image with hidden cells: without all of its cells nothing is left.
TEST_F(SmartInput, AGridOfHiddenCells)
{
  const auto image = imageOf(sineField(), unitCube(6));
  markCells(image, vtkDataSetAttributes::HIDDENCELL, [](vtkIdType) { return true; });
  this->expectEmptyWithoutErrors(image);
  vtkNew<vtkUniformGrid> grid;
  grid->ShallowCopy(this->Shown.Data);
  const ErrorWatch watch(this->Shown.Mapper);
  this->show(grid);
  this->expectSound();
  EXPECT_EQ(watch.Errors, Words());
}
} // namespace
