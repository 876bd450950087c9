// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeData.h"

#include "TestGrids.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

namespace
{
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
  const auto grid = MakeThreeLayers();
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
