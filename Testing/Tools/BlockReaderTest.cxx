// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks: of images and rectilinear grids they stay a tree, else they become one grid.
#include "ReaderCase.h"
#include "TestGrids.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkXMLMultiBlockDataWriter.h"

namespace
{
using BlockReader = ReaderCase;
using tetmarch::ReadVolume;

vtkSmartPointer<vtkImageData> MakeImage(int slices)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(3, 3, slices);
  AddArray<vtkDoubleArray>(image->GetPointData(), "s", image->GetNumberOfPoints());
  return image;
}

vtkSmartPointer<vtkRectilinearGrid> MakeRectilinear()
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->InsertNextValue(5.0);
  coordinates->InsertNextValue(6.0);
  grid->SetDimensions(2, 2, 2);
  grid->SetXCoordinates(coordinates);
  grid->SetYCoordinates(coordinates);
  grid->SetZCoordinates(coordinates);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "s", 8);
  return grid;
}

vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(const std::vector<vtkDataObject*>& blocks)
{
  auto tree = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (vtkDataObject* block : blocks)
  {
    const unsigned int number = tree->GetNumberOfBlocks();
    tree->SetBlock(number, block);
    tree->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), "number " + std::to_string(number));
  }
  return tree;
}
} // namespace

TEST_F(BlockReader, BlocksOfImagesStayImages)
{
  const auto image = MakeImage(3), flat = MakeImage(1);
  const auto grid = MakeRectilinear();
  vtkNew<vtkPolyData> surface;
  const auto blocks = MakeBlocks({ surface, image, flat, grid });
  const std::string path = this->Write<vtkXMLMultiBlockDataWriter>("blocks.vtm", blocks);
  const auto volume = ReadVolume(path, std::nullopt);
  EXPECT_TRUE(volume.Structured);
  ASSERT_EQ(volume.Blocks.size(), 2u);
  auto* tree = vtkMultiBlockDataSet::SafeDownCast(volume.Input);
  ASSERT_NE(tree, nullptr);
  ASSERT_EQ(tree->GetNumberOfBlocks(), 2u);
  EXPECT_EQ(tree->GetBlock(0), volume.Blocks[0]);
  EXPECT_TRUE(vtkImageData::SafeDownCast(volume.Blocks[0]));
  EXPECT_TRUE(vtkRectilinearGrid::SafeDownCast(volume.Blocks[1]));
  EXPECT_STREQ(tree->GetMetaData(1u)->Get(vtkCompositeDataSet::NAME()), "number 3");
}

TEST_F(BlockReader, OneImageIsNoTree)
{
  const auto image = MakeImage(3), flat = MakeImage(1);
  const auto blocks = MakeBlocks({ flat, image });
  const std::string path = this->Write<vtkXMLMultiBlockDataWriter>("blocks.vtm", blocks);
  const auto volume = ReadVolume(path, std::nullopt);
  EXPECT_TRUE(volume.Structured);
  ASSERT_EQ(volume.Blocks.size(), 1u);
  EXPECT_EQ(volume.Input, volume.Blocks[0]);
  EXPECT_EQ(volume.Blocks[0]->GetNumberOfPoints(), 27);
}

TEST_F(BlockReader, ImagesAmongOtherBlocksBecomeHexahedra)
{
  const auto image = MakeImage(3);
  const auto voxel = MakeVoxel(2.0);
  AddArray<vtkDoubleArray>(voxel->GetPointData(), "s", 8);
  const auto blocks = MakeBlocks({ image, voxel });
  const std::string path = this->Write<vtkXMLMultiBlockDataWriter>("blocks.vtm", blocks);
  const auto volume = ReadVolume(path, std::nullopt);
  EXPECT_FALSE(volume.Structured);
  ASSERT_EQ(volume.Blocks.size(), 1u);
  EXPECT_EQ(volume.Input, volume.Blocks[0]);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(volume.Input);
  ASSERT_NE(grid, nullptr);
  EXPECT_EQ(grid->GetNumberOfCells(), 9);
  EXPECT_EQ(grid->GetNumberOfPoints(), 27 + 4);
}
