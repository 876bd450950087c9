// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeData.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRectilinearGrid.h"

#include <gtest/gtest.h>

namespace
{
vtkSmartPointer<vtkDoubleArray> MakeCoordinates(const std::vector<double>& values)
{
  auto coordinates = vtkSmartPointer<vtkDoubleArray>::New();
  for (double value : values)
  {
    coordinates->InsertNextValue(value);
  }
  return coordinates;
}

vtkSmartPointer<vtkRectilinearGrid> MakeRectilinear()
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(3, 2, 4);
  grid->SetXCoordinates(MakeCoordinates({ 0, 1, 4 }));
  grid->SetYCoordinates(MakeCoordinates({ -1, 1 }));
  grid->SetZCoordinates(MakeCoordinates({ 3, 4, 5, 6 }));
  return grid;
}

vtkSmartPointer<vtkImageData> MakeImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(3, 3, 3);
  image->SetSpacing(1, 2, 3);
  return image;
}
} // namespace

TEST(VolumeData, MeanSpacing)
{
  const auto grid = MakeRectilinear();
  const auto image = MakeImage();
  const auto spacing = [](const std::vector<vtkDataSet*>& blocks) {
    return tetmarch::GetMeanSpacing({ blocks[0], blocks, true });
  };
  EXPECT_DOUBLE_EQ(spacing({ image }), 2.0);
  image->SetSpacing(-1, 2, 3);
  EXPECT_DOUBLE_EQ(spacing({ image }), 2.0);
  EXPECT_DOUBLE_EQ(spacing({ grid }), 5.0 / 3.0);
  EXPECT_DOUBLE_EQ(spacing({ image, grid }), 11.0 / 6.0);
}
