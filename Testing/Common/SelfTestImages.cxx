// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The comparison of images: every figure on images made by hand.
#include "Images.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>

namespace
{
using namespace tetmarch::testing;

TEST(Images, RefusesDifferentSizes)
{
  EXPECT_THROW(compare(Image(2, 3), Image(3, 2)), std::invalid_argument);
  EXPECT_THROW(compare(Image(2, 3), Image(2, 3), Mask(5)), std::invalid_argument);
  EXPECT_THROW(silhouette(Image(2, 3), Image(2, 2)), std::invalid_argument);
}

TEST(Images, Figures)
{
  const Image a(100, 50);
  Image b(100, 50);
  EXPECT_EQ(compare(a, b).Max, 0.0);
  // Six of 5000 pixels: five may be passed over by the percentile, the next worst is the smallest.
  for (int i = 0; i < 6; ++i)
  {
    b.pixel(10 + i, 7)[i % 4] = 0.125f * static_cast<float>(i + 1);
  }
  const Difference all = compare(a, b, {}, 0.3);
  EXPECT_EQ(all.Pixels, 5000u);
  EXPECT_EQ(all.Max, 0.75);
  EXPECT_EQ(all.WorstX, 15);
  EXPECT_EQ(all.WorstY, 7);
  EXPECT_EQ(all.Over, 4u);
  EXPECT_EQ(all.Percentile999, 0.125);
  EXPECT_NEAR(all.Rms, std::sqrt(0.015625 * (1 + 4 + 9 + 16 + 25 + 36) / 20000), 1e-15);
  // Only pixel 13 has alpha.
  const Difference masked = compare(a, b, silhouette(a, b));
  EXPECT_EQ(masked.Pixels, 1u);
  EXPECT_EQ(masked.Max, 0.5);
  EXPECT_EQ(masked.Rms, 0.25);
  EXPECT_EQ(compare(a, b, silhouette(a, b), 0.1, Channels::Rgb).Max, 0.0);
  const float black[3] = { 0.0f, 0.0f, 0.0f };
  EXPECT_EQ(compare(a, b, differsFrom(b, black)).Pixels, 5u);
  EXPECT_EQ(differenceImage(a, b, 4.0f).pixel(10, 7)[0], 0.5f);
}

TEST(Images, NotANumberIsAnInfiniteDifference)
{
  const Image a(4, 4);
  Image b(4, 4);
  b.pixel(1, 2)[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(compare(a, b, silhouette(a, b)).Pixels, 1u);
  EXPECT_TRUE(std::isinf(compare(a, b).Max));
  EXPECT_EQ(compare(a, b).Over, 1u);
}

TEST(Images, PngRoundTrip)
{
  Image image(5, 3);
  for (std::size_t i = 0; i < image.Rgba.size(); ++i)
  {
    image.Rgba[i] = static_cast<float>(i * 4) / 255.0f;
  }
  const std::string name = ::testing::TempDir() + "TetMarchTestCommonImage.png";
  ASSERT_TRUE(writePng(image, name, Channels::Rgba));
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfScalarComponents(), 4);
  const Image again =
    Image::fromBytes(5, 3, static_cast<unsigned char*>(reader->GetOutput()->GetScalarPointer()));
  EXPECT_EQ(compare(image, again).Max, 0.0);
  std::remove(name.c_str());
}
} // namespace
