// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// All combinations of the bits of a variant: distinct defines, and a filter that drops what has no
// effect, and nothing else.
#include "LegalKeys.h"

#include <gtest/gtest.h>
#include <iostream>
#include <random>
#include <set>

namespace
{
using namespace tetmarch::testing;
using tetmarch::VariantKey;

constexpr int Count = VariantKey::NumberOfBits;

// Whether each bit of the key changes something; in the words of the members, one by one.
bool isSensible(const VariantKey& k)
{
  const bool ofLight = k.HeadlightOnly || k.SingleLight || k.WorldLights || k.Scattering ||
                       k.CastShadows || k.SampledShadows || k.SeveralShadows || k.OpaqueShadows ||
                       k.HeadlightShadows || k.Occlusion;
  // Who doesn't know where a ray comes in has to look for it.
  return (k.RasterEntry || k.Hierarchy) &&
         // Parts of rays end where they are asked to, and aren't counted.
         !(k.Peeled && (k.OpaqueDepth || k.Diagnostics)) &&
         // What is constant is integrated exactly, and has no gradient in a cell.
         !(!k.PointScalars && (k.Adaptive || k.CellGradients)) &&
         !(k.ConstantColor && k.Adaptive) &&
         // No colour of the volume is seen.
         !(k.ConstantColor && (k.ShowIllumination || k.ShowGradients)) &&
         // Nothing uses gradients.
         !(k.CellGradients && !k.GradientOpacity && !k.Shading && !k.ShowGradients) &&
         // There is no light.
         !(ofLight && !k.Shading) &&
         // The only light stands at the eye, and needs no world.
         !(k.HeadlightOnly && (k.SingleLight || k.WorldLights || k.CastShadows)) &&
         // Or elsewhere.
         !(k.SingleLight && (k.SeveralShadows || k.HeadlightShadows)) &&
         // No shadows to be sampled.
         !((k.SampledShadows || k.SeveralShadows) && !k.CastShadows) &&
         // No light that opaque geometry could keep off.
         !(k.OpaqueShadows && !k.CastShadows) &&
         // Gradients are shown instead of the light.
         !(k.ShowGradients && (k.Shading || k.ShowIllumination));
}

TEST(VariantKey, KeysAreEqualIfAllBitsAre)
{
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i)
  {
    const unsigned int a = random() % NumberOfKeys;
    const VariantKey key = keyOf(a);
    EXPECT_EQ(numberOf(key), a);
    EXPECT_TRUE(key == keyOf(a));
    for (int bit = 0; bit < Count; ++bit)
    {
      const VariantKey other = keyOf(a ^ 1u << bit);
      EXPECT_FALSE(key == other);
      EXPECT_NE(key.defines(), other.defines());
    }
  }
}

TEST(VariantKey, MembersAreBits)
{
  std::set<std::string> names;
  for (const VariantKey::Bit& bit : VariantKey::bits())
  {
    EXPECT_TRUE(names.insert(bit.Name).second) << bit.Name;
  }
  // A member without a row would be lost between a key and its number.
  EXPECT_EQ(sizeof(VariantKey), static_cast<std::size_t>(Count));
}

TEST(VariantKey, FilterDropsWhatChangesNothing)
{
  std::mt19937 random(3);
  for (int n = 0; n < 1000000; ++n)
  {
    const VariantKey asked = keyOf(random() % NumberOfKeys);
    const VariantKey got = asked.filtered();
    ASSERT_TRUE(isSensible(got)) << namesOf(asked) << " -> " << namesOf(got);
    ASSERT_TRUE(got == got.filtered()) << namesOf(got);
    ASSERT_EQ(got == asked, isSensible(asked)) << namesOf(asked);
    for (int i = 0; i < Count; ++i)
    {
      const VariantKey::Bit& bit = VariantKey::bits()[i];
      if (got.*bit.Member && !(asked.*bit.Member))
      {
        ASSERT_EQ(bit.Member, &VariantKey::Hierarchy) << namesOf(asked) << ": " << bit.Name;
        ASSERT_FALSE(asked.RasterEntry);
      }
      if (asked.*bit.Member && !(got.*bit.Member))
      {
        ASSERT_FALSE(isSensible(keyOf(numberOf(got) | 1u << i)))
          << namesOf(asked) << " has lost " << bit.Name;
      }
    }
  }
}

// Counted by hand: entries found by the rasteriser, by it and a search, or by a search; up to
// opaque geometry or not, with counters or not, or in parts; fused or not; with transparent ranges
// or not; of scalars at points, adaptive or not, or of cells. Effects of scalars at points: 4 times
// gradients shown; 2 and 4 times no light, without and with opacity by gradients; 16 of light times
// 4 of a headlight alone, 20 of another light alone and 72 of others, by whether the volume casts
// shadows, of one light or several, where these are looked for, and whether opaque geometry casts
// some into it. A constant colour is neither adaptive nor shown without itself.
TEST(VariantKey, LegalKeysAreCounted)
{
  const std::size_t lit = 4 + 20 + 72;
  const std::size_t ofPoints = 4 + 2 + 4 + 16 * lit;
  const std::size_t ofCells = 2 + 2 + 2 + 8 * lit;
  // Of one colour only.
  const std::size_t ofColoredPoints = 1 + 2 + 8 * lit;
  const std::size_t ofColoredCells = 1 + 1 + 4 * lit;
  const std::size_t legal = legalKeys().size();
  EXPECT_EQ(
    legal, 3 * (2 * 2 + 1) * 2 * 2 * (2 * ofPoints + ofCells + ofColoredPoints + ofColoredCells));
  const std::size_t light = legalLightKeys().size();
  EXPECT_EQ(light, 2 * 2 * 2 * (3 + 2));
  // Of scalars at points or cells, with opacity by gradients of either kind or without.
  const std::size_t picked = legalPickKeys().size();
  EXPECT_EQ(picked, 3 * 2 * (3 + 2));
  std::cout << "[ MEASURED ] " << legal << " variants of the picture, " << light
            << " of the light at vertices, " << picked << " of what is picked, of " << NumberOfKeys
            << " combinations of bits\n";
}

// Towards the light only extinction counts, and what stands in the way.
TEST(VariantKey, LightAtVerticesIsExtinctionAlone)
{
  for (const VariantKey& picture : legalKeys())
  {
    VariantKey light = picture.ofVertexLight();
    ASSERT_EQ(light.OpaqueShadows, picture.OpaqueShadows);
    light.OpaqueShadows = false;
    ASSERT_TRUE(light == light.filtered());
    ASSERT_EQ(light.PointScalars, picture.PointScalars);
    ASSERT_EQ(light.Hierarchy, picture.Hierarchy);
    ASSERT_EQ(light.HasFma, picture.HasFma);
    ASSERT_EQ(light.GradientOpacity, picture.GradientOpacity);
    ASSERT_EQ(light.CellGradients, picture.CellGradients && picture.GradientOpacity);
    ASSERT_FALSE(light.OpaqueDepth || light.Adaptive || light.Diagnostics || light.Shading ||
                 light.ShowIllumination || light.ShowGradients)
      << namesOf(light);
  }
}

// What is picked depends on extinction alone, and ends at whatever else is drawn.
TEST(VariantKey, PicksKnowExtinctionAlone)
{
  for (const VariantKey& picture : legalKeys())
  {
    VariantKey pick = picture.ofPick();
    ASSERT_TRUE(pick == pick.filtered());
    ASSERT_TRUE(pick.OpaqueDepth);
    ASSERT_EQ(pick.PointScalars, picture.PointScalars);
    ASSERT_EQ(pick.GradientOpacity, picture.GradientOpacity);
    ASSERT_EQ(pick.CellGradients, picture.CellGradients && picture.GradientOpacity);
    pick.PointScalars = true;
    pick.GradientOpacity = pick.CellGradients = false;
    VariantKey entries = picture.ofEntries();
    entries.OpaqueDepth = true;
    ASSERT_TRUE(pick == entries) << namesOf(pick);
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
