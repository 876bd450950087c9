// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks: of images and rectilinear grids they stay a tree, else they become one grid.
#include "ReaderCase.h"
#include "TestGrids.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkTetMarchFirstPicture.h"
#include "vtkXMLMultiBlockDataWriter.h"

#include <algorithm>

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

namespace
{
using Arrays = std::vector<std::string>;

/// Point arrays by their names: of ints "i NAME", floats "f NAME", doubles "d NAME",
/// vectors "v NAME".
void AddArrays(vtkDataSet* data, const Arrays& names)
{
  for (const std::string& name : names)
  {
    const vtkIdType count = data->GetNumberOfPoints();
    const std::string bare = name.substr(name.find(' ') + 1);
    name[0] == 'i'   ? AddArray<vtkIntArray>(data->GetPointData(), bare.c_str(), count)
    : name[0] == 'f' ? AddArray<vtkFloatArray>(data->GetPointData(), bare.c_str(), count)
    : name[0] == 'v' ? AddArray<vtkDoubleArray>(data->GetPointData(), bare.c_str(), count, 3)
                     : AddArray<vtkDoubleArray>(data->GetPointData(), bare.c_str(), count);
  }
}

std::string Choose(vtkDataObject* data)
{
  vtkNew<vtkTetMarchFirstPicture> choice;
  choice->SetInputData(data);
  return choice->ChooseArray() ? choice->Describe() : "nothing";
}
} // namespace

// What vtkTetMarchFirstPicture is given by Python: the tree. By the programs: what they read of it.
TEST_F(BlockReader, TheArrayIsThatOfTheTree)
{
  const struct
  {
    Arrays OfImage, OfGrid;
    std::string Chosen;
  } cases[] = {
    { { "d a", "d b" }, { "d b", "d a" }, "a" }, { { "d only here", "d b" }, { "d b" }, "b" },
    { { "d b" }, { "d only here", "d b" }, "b" }, { { "f a" }, { "d a" }, "a" }, // other types
    { { "i a", "d b" }, { "d a", "d b" }, "a" },          // floating-point in one of them
    { { "v a", "d b" }, { "d a", "d b" }, "b" },          // other numbers of components
    { { "d only here" }, { "d or there" }, "only here" }, // no array in both
  };
  for (const auto& c : cases)
  {
    const auto image = MakeImage(3);
    image->GetPointData()->RemoveArray("s");
    const auto voxel = MakeVoxel(2.0);
    AddArrays(image, c.OfImage);
    AddArrays(voxel, c.OfGrid);
    const auto flat = MakeImage(1); // is not drawn, so its arrays don't count
    const auto tree = MakeBlocks({ flat, image, voxel });
    const std::string path = this->Write<vtkXMLMultiBlockDataWriter>("blocks.vtm", tree);
    const std::string chosen = Choose(tree);
    EXPECT_EQ(chosen.substr(0, chosen.find(" on ")), c.Chosen);
    EXPECT_EQ(Choose(ReadVolume(path, std::nullopt).Input), chosen) << c.Chosen;
  }
}

TEST_F(BlockReader, BlocksWithoutTheArrayAreLeftOutWithAWarning)
{
  const auto image = MakeImage(3);
  const auto voxel = MakeVoxel(2.0);
  AddArrays(voxel, { "d other" });
  for (vtkDataSet* block : { static_cast<vtkDataSet*>(image), static_cast<vtkDataSet*>(voxel) })
  {
    block->AllocatePointGhostArray(); // is an array of all blocks, but none to draw
  }
  const auto tree = MakeBlocks({ image, voxel });
  const std::string path = this->Write<vtkXMLMultiBlockDataWriter>("blocks.vtm", tree);
  testing::internal::CaptureStderr();
  EXPECT_EQ(ReadVolume(path, std::nullopt).Input->GetNumberOfElements(vtkDataObject::CELL), 8);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
    "tetmarch-render: warning: blocks without point array 's' are not drawn: \"number 1\"\n");
}

// As mappers draw a tree, and so Python.
TEST_F(BlockReader, TheWantedArrayChoosesTheBlocks)
{
  const std::vector<vtkSmartPointer<vtkUnstructuredGrid>> voxels = { MakeVoxel(0.0), MakeVoxel(2.0),
    MakeVoxel(4.0) };
  for (const auto& voxel : voxels)
  {
    AddArrays(voxel, { "d all" });
  }
  AddArrays(voxels[1], { "d some" });
  AddArrays(voxels[2], { "d some", "v once" });
  AddArray<vtkDoubleArray>(voxels[0]->GetCellData(), "some", 1);
  const auto tree = MakeBlocks({ voxels[0], voxels[1], voxels[2] });
  tree->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "left");
  tree->GetMetaData(1u)->Remove(vtkCompositeDataSet::NAME());
  const std::string path = this->Write<vtkXMLMultiBlockDataWriter>("blocks.vtm", tree);
  using First = vtkTetMarchFirstPicture;
  const struct
  {
    const char* Wanted;
    int Association;
    std::vector<double> Drawn; // where the blocks begin
    const char* Warning;
  } cases[] = {
    { "all", First::ANY, { 0.0, 2.0, 4.0 }, "" },
    { "some", First::ANY, { 2.0, 4.0 },
      "blocks without point array 'some' are not drawn: \"left\"" },
    { "some", First::CELLS, { 0.0 },
      "blocks without cell array 'some' are not drawn: number 2, \"number 2\"" },
    { "once", First::ANY, { 4.0 },
      "blocks without point array 'once' are not drawn: \"left\", number 2" },
    { "none", First::ANY, { 0.0, 2.0, 4.0 }, "" }, // refused later, with a list of what there is
  };
  for (const auto& c : cases)
  {
    testing::internal::CaptureStderr();
    const auto volume = ReadVolume(path, std::nullopt, {}, { c.Wanted, c.Association });
    const std::string told = testing::internal::GetCapturedStderr();
    const std::size_t warning = told.find("blocks without");
    const std::size_t end = std::min(told.find('\n', warning), told.size());
    EXPECT_EQ(warning < end ? told.substr(warning, end - warning) : "", c.Warning);
    auto* grid = vtkUnstructuredGrid::SafeDownCast(volume.Input);
    ASSERT_NE(grid, nullptr);
    std::vector<double> drawn;
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      drawn.push_back(grid->GetCell(i)->GetBounds()[0]);
    }
    EXPECT_EQ(drawn, c.Drawn) << c.Wanted;
    vtkNew<First> choice;
    choice->SetInputData(volume.Input);
    choice->SetArrayName(c.Wanted);
    choice->SetArrayAssociation(c.Association);
    EXPECT_EQ(choice->ChooseArray(), std::string(c.Wanted) != "none");
  }
}
