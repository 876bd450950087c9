// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Every variant of the march shader: distinct defines, and a filter that settles at once.
#include "Scene/VariantKey.h"

#include <gtest/gtest.h>
#include <random>

namespace
{
using tetmarch::VariantKey;

constexpr int Count = VariantKey::NumberOfBits;

VariantKey keyOf(unsigned int number)
{
  VariantKey key;
  for (int i = 0; i < Count; ++i)
  {
    key.*VariantKey::bits()[i].Member = (number >> i & 1u) != 0;
  }
  return key;
}

TEST(VariantKey, KeysAreEqualIfAllBitsAre)
{
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i)
  {
    const unsigned int a = random() % (1u << Count);
    const VariantKey key = keyOf(a);
    EXPECT_TRUE(key == keyOf(a));
    for (int bit = 0; bit < Count; ++bit)
    {
      const VariantKey other = keyOf(a ^ 1u << bit);
      EXPECT_FALSE(key == other);
      EXPECT_NE(key.defines(), other.defines());
    }
  }
}

// Variants that march differently look for entries alike.
TEST(VariantKey, EntriesDependOnFewBits)
{
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i)
  {
    const VariantKey key = keyOf(random() % (1u << Count));
    VariantKey other = keyOf(random() % (1u << Count));
    other.RasterEntry = key.RasterEntry;
    other.Hierarchy = key.Hierarchy;
    other.OpaqueDepth = key.OpaqueDepth;
    other.HasFma = key.HasFma;
    const VariantKey entries = key.ofEntries();
    EXPECT_EQ(entries.defines(), other.ofEntries().defines());
    EXPECT_TRUE(entries == entries.filtered());
    EXPECT_EQ(entries.RasterEntry, key.RasterEntry);
    EXPECT_EQ(entries.Hierarchy, key.Hierarchy || !key.RasterEntry);
    EXPECT_EQ(entries.OpaqueDepth, key.OpaqueDepth);
    EXPECT_EQ(entries.HasFma, key.HasFma);
    EXPECT_FALSE(entries.hasGradients() || entries.hasErrorBound());
  }
}
} // namespace
