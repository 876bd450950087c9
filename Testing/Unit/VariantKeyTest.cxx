// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Every variant of the march shader: distinct defines, and a filter that settles at once.
#include "Scene/VariantKey.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace
{
using tetmarch::VariantKey;

constexpr bool VariantKey::*Bits[] = { &VariantKey::PointScalars, &VariantKey::RasterEntry,
  &VariantKey::Hierarchy, &VariantKey::OpaqueDepth, &VariantKey::HasFma, &VariantKey::Adaptive,
  &VariantKey::Diagnostics };
constexpr int Count = static_cast<int>(std::size(Bits));

VariantKey keyOf(int number)
{
  VariantKey key;
  for (int i = 0; i < Count; ++i)
  {
    key.*Bits[i] = (number >> i & 1) != 0;
  }
  return key;
}

TEST(VariantKey, KeysAreEqualIfAllBitsAre)
{
  std::set<std::string> texts;
  for (int a = 0; a < 1 << Count; ++a)
  {
    for (int b = 0; b < 1 << Count; ++b)
    {
      ASSERT_EQ(keyOf(a) == keyOf(b), a == b);
    }
    texts.insert(keyOf(a).defines());
  }
  EXPECT_EQ(texts.size(), std::size_t(1) << Count);
}

TEST(VariantKey, DefinesNameEveryBit)
{
  for (int a = 0; a < 1 << Count; ++a)
  {
    const std::string text = keyOf(a).defines();
    EXPECT_EQ(
      std::count(text.begin(), text.end(), '\n'), Count + 1); // and the error bound, which follows
    EXPECT_EQ(std::count(text.begin(), text.end(), '#'), Count + 1);
  }
  EXPECT_NE(VariantKey().defines().find("#define TETMARCH_POINT_SCALARS 1\n"), std::string::npos);
}

TEST(VariantKey, FilterSettlesAtOnceAndKeepsWhatIsAskedFor)
{
  for (int a = 0; a < 1 << Count; ++a)
  {
    const VariantKey key = keyOf(a);
    const VariantKey filtered = key.filtered();
    EXPECT_TRUE(filtered == filtered.filtered());
    // Without the rasteriser entries are searched for in the hierarchy.
    EXPECT_EQ(filtered.Hierarchy, key.Hierarchy || !key.RasterEntry);
    // Nothing has to be split where scalars are constant.
    EXPECT_EQ(filtered.Adaptive, key.Adaptive && key.PointScalars);
    EXPECT_EQ(filtered.hasErrorBound(), key.PointScalars && (key.Adaptive || key.Diagnostics));
    VariantKey rest = filtered;
    rest.Hierarchy = key.Hierarchy;
    rest.Adaptive = key.Adaptive;
    EXPECT_TRUE(rest == key);
  }
}
} // namespace
