// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The kernels for pictures on the CPU are those that keys ask for: Variants/features.txt says in
// its own words what VariantKey::filtered() does.
#include "Reference/KernelTable.h"
#include "Variants/VariantKey.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace
{
using namespace tetmarch;

using Feature = VariantKey::Feature;

std::vector<Feature> chosen()
{
  std::vector<Feature> found;
  for (const Feature& feature : VariantKey::features())
  {
    if (feature.Bit & chosenFeatures())
    {
      found.push_back(feature);
    }
  }
  return found;
}

VariantKey keyOf(std::uint64_t bits)
{
  VariantKey key;
  for (const Feature& feature : VariantKey::features())
  {
    if (feature.Bit & (bits | chosenFeatures()))
    {
      feature.set(key, (feature.Bit & bits) != 0);
    }
  }
  return key;
}

TEST(KernelTable, HasAKernelForEveryKey)
{
  const auto features = chosen();
  ASSERT_GT(features.size(), 10u);
  for (std::uint64_t set = 0; set < std::uint64_t(1) << features.size(); ++set)
  {
    VariantKey key = keyOf(0);
    for (std::size_t i = 0; i < features.size(); ++i)
    {
      if (set >> i & 1)
      {
        features[i].set(key, true);
      }
    }
    const std::uint64_t asked = key.filtered().bits() & chosenFeatures();
    EXPECT_EQ(std::count_if(pictureKernels().begin(), pictureKernels().end(),
                [asked](const PictureKernel& kernel) { return kernel.Chosen == asked; }),
      1)
      << key.filtered().defines();
  }
}

TEST(KernelTable, HasNoKernelThatNoKeyAsksFor)
{
  for (const PictureKernel& kernel : pictureKernels())
  {
    const VariantKey key = keyOf(kernel.Chosen);
    EXPECT_EQ(key.filtered().bits() & chosenFeatures(), kernel.Chosen) << key.defines();
  }
}

} // namespace
