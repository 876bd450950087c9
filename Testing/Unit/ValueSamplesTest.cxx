// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/ArrayChoice.h"
#include "FirstPicture/Samples.h"

#include "TestGrids.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
std::vector<tetmarch::Sample> TakeAll(
  const std::vector<vtkDataSet*>& blocks, const char* name, int component = 0)
{
  tetmarch::DrawnArray drawn;
  EXPECT_EQ(tetmarch::chooseArray(blocks, { name, std::nullopt, component }, drawn), "");
  return tetmarch::takeSamples(blocks, drawn);
}

vtkSmartPointer<vtkRectilinearGrid> MakeRectilinearWithCells()
{
  auto grid = MakeThreeLayers();
  AddArray<vtkDoubleArray>(grid->GetCellData(), "c", 6);
  return grid;
}

vtkSmartPointer<vtkImageData> MakeImage(int size)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, size);
  image->SetSpacing(1, 2, 3);
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName("plane");
  array->SetNumberOfValues(vtkIdType(size) * size * size);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetValue(i, static_cast<unsigned char>(i % size)); // the number along x
  }
  image->GetPointData()->AddArray(array);
  return image;
}
} // namespace

TEST(Samples, MeanOfTheCellsPoints)
{
  auto grid = MakeVoxel(0.0);
  AddArray<vtkDoubleArray>(grid->GetPointData(), "p", 8);
  AddArray<vtkDoubleArray>(grid->GetCellData(), "c", 1);
  auto samples = TakeAll({ grid }, "p");
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_DOUBLE_EQ(samples[0].Value, 3.5);
  EXPECT_DOUBLE_EQ(samples[0].Volume, 1.0);

  auto* values = vtkDoubleArray::SafeDownCast(grid->GetPointData()->GetArray("p"));
  values->SetValue(3, std::nan(""));
  EXPECT_TRUE(TakeAll({ grid }, "p").empty());
}

TEST(Samples, CellsOfRectilinearGridsHaveTheirOwnVolume)
{
  const auto grid = MakeRectilinearWithCells();
  const auto samples = TakeAll({ grid }, "c");
  ASSERT_EQ(samples.size(), 6u);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    EXPECT_EQ(samples[i].Value, static_cast<double>(i));
    EXPECT_DOUBLE_EQ(samples[i].Volume, i % 2 == 0 ? 2.0 : 6.0);
  }
}

// 255^3 cells: every 16th cell of all would be one plane in 15 or so along x.
TEST(Samples, OfLargeImagesComeFromAllOver)
{
  const auto image = MakeImage(256);
  const auto samples = TakeAll({ image }, "plane");
  EXPECT_GT(samples.size(), 500000u);
  EXPECT_LE(samples.size(), 1u << 20);
  std::array<int, 255> counts{};
  for (const auto& sample : samples)
  {
    EXPECT_EQ(sample.Volume, 6.0);
    ++counts.at(static_cast<std::size_t>(sample.Value)); // the middle of the cell, rounded down
  }
  for (std::size_t i = 0; i < counts.size(); i += 3)
  {
    EXPECT_EQ(counts[i], 85 * 85);
  }
}

TEST(Samples, BlocksWithoutTheArrayHaveNone)
{
  const auto grid = MakeRectilinearWithCells();
  const auto image = MakeImage(3);
  EXPECT_EQ(TakeAll({ image, grid }, "c").size(), 6u);
  EXPECT_EQ(TakeAll({ image, grid }, "plane").size(), 8u);
  AddArray<vtkDoubleArray>(image->GetCellData(), "c", 8, 2);
  EXPECT_EQ(TakeAll({ image, grid }, "c", 1).size(), 8u); // the other has no component 1
  EXPECT_EQ(TakeAll({ image, grid }, "c").size(), 14u);
}
