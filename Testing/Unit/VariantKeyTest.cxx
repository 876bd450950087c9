// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// All combinations of the bits of a variant: distinct defines, and a filter that drops what has no
// effect, and nothing else.
#include "LegalKeys.h"
#include "SensibleKey.h"

#include <gtest/gtest.h>
#include <iostream>
#include <random>
#include <set>

namespace
{
using namespace tetmarch::testing;
using tetmarch::BlendGroup;
using tetmarch::ComponentGroup;
using tetmarch::VariantKey;

constexpr int Count = VariantKey::NumberOfFeatures;

TEST(VariantKey, KeysAreEqualIfAllBitsAre)
{
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i)
  {
    const VariantKey key = randomKey(random);
    EXPECT_TRUE(key == keyOf(key.bits()));
    for (const VariantKey::Feature& feature : VariantKey::features())
    {
      VariantKey other = key;
      feature.set(other, !feature.isOn(key));
      EXPECT_EQ(feature.isOn(other), !feature.isOn(key));
      EXPECT_FALSE(key == other);
      EXPECT_NE(key.defines(), other.defines());
    }
  }
}

TEST(VariantKey, MembersAreFeatures)
{
  std::set<std::string> names;
  std::uint64_t bits = 0;
  std::size_t members = 2; // the groups
  for (const VariantKey::Feature& feature : VariantKey::features())
  {
    EXPECT_TRUE(names.insert(feature.Name).second) << feature.Name;
    EXPECT_EQ(bits & feature.Bit, 0u) << feature.Name;
    bits |= feature.Bit;
    members += feature.Value.index() == 0 ? 1 : 0;
  }
  // A member without a row would be lost between a key and its bits.
  EXPECT_EQ(sizeof(VariantKey), members);
}

// A group has one value at a time.
TEST(VariantKey, GroupsHaveOneValue)
{
  for (const VariantKey::Feature& feature : VariantKey::features())
  {
    for (const VariantKey::Feature& other : VariantKey::features())
    {
      VariantKey key;
      other.set(key, true);
      feature.set(key, true);
      EXPECT_TRUE(feature.isOn(key)) << feature.Name;
      const bool replaced = &feature != &other && feature.Value.index() > 0 &&
                            feature.Value.index() == other.Value.index();
      EXPECT_EQ(other.isOn(key), !replaced) << feature.Name << " after " << other.Name;
      feature.set(key, false);
      EXPECT_FALSE(feature.isOn(key)) << feature.Name;
    }
  }
}

TEST(VariantKey, FilterDropsWhatChangesNothing)
{
  std::mt19937 random(3);
  for (int n = 0; n < 1000000; ++n)
  {
    const VariantKey asked = randomKey(random);
    const VariantKey got = asked.filtered();
    ASSERT_TRUE(isSensible(got)) << namesOf(asked) << " -> " << namesOf(got);
    ASSERT_TRUE(got == got.filtered()) << namesOf(got);
    ASSERT_EQ(got == asked, isSensible(asked)) << namesOf(asked);
    for (int i = 0; i < Count; ++i)
    {
      const VariantKey::Feature& feature = VariantKey::features()[i];
      const std::string name = feature.Name;
      if (feature.isOn(got) && !feature.isOn(asked))
      {
        const bool searched = name == "BVH" && !asked.EntryLists;
        const bool cut = name == "CLIPPED" && asked.Cropped;
        const bool many = name == "MANY_SLABS" && asked.Slabs && got.hasComponents();
        const bool jumps = name == "CELL_GRADIENTS" && asked.CornerScalars;
        const bool parted = name == "REENTERED" && asked.VisiblePart;
        const bool sampled = name == "SAMPLED_SHADOWS" && asked.LightTolerance;
        ASSERT_TRUE(searched || cut || many || jumps || parted || sampled)
          << namesOf(asked) << ": " << name;
      }
      if (feature.isOn(asked) && !feature.isOn(got))
      {
        VariantKey more = got;
        feature.set(more, true);
        ASSERT_FALSE(isSensible(more)) << namesOf(asked) << " has lost " << name;
      }
    }
  }
}

// Rays towards the light: of scalars at points or of cells, with what is not finite and with hidden
// cells or without; past opaque geometry or not, and with gradient opacity of points in two ways,
// of corners and of cells in one, or without. Through a mesh in one part or several, fused or not,
// in one buffer or two; through a curvilinear grid, whose sides meet or not; through a lattice
// whose planes are even or not, with leaps or without, or with leaves of scalars of cells, and
// whose values are in one texture, in two or in many. Cuts let light through or not.
TEST(VariantKey, LegalKeysAreCounted)
{
  const std::size_t light = legalLightKeys().size();
  const std::size_t ofMeshes = 2 * 2 * 2 * 2 * 2 * (3 + 2 + 2);
  const std::size_t ofVolumes = 2 * 2 * 2 * 2 * 2 * (3 + 2);
  const std::size_t ofCurvilinear = 2 * ofVolumes; // its sides meet or not; corners have no scalars
  const std::size_t ofLeaves = 2 * 2 * 2 * 2 * 2;
  EXPECT_EQ(light, 2 * (2 * ofMeshes + ofCurvilinear + 3 * ofVolumes + ofLeaves));
  // Entries are listed, of all of the mesh or of a part, or searched for. Of scalars at points,
  // corners or cells, clipped, cropped or whole, with hidden cells or not; of volumes with opacity
  // by gradients of either kind or without, or of independent components, with what is not finite
  // or not; or in three other blend modes. Of a mesh in one buffer or two; of a curvilinear grid
  // with joined sides or not, without corners; or of a lattice, whose planes are even or not,
  // volumes are leapt to or not, and so are surfaces in trilinear cells; in one texture, two, many.
  // Of leaves of scalars of cells.
  const std::size_t picked = legalPickKeys().size();
  const std::size_t searched = (3 + 2 + 2 + 2) * 2 + 3 * 3;
  const std::size_t withoutCorners = (3 + 2 + 2) * 2 + 3 * 2;
  const std::size_t ofTetrahedra = 2 * 3 * 2 * (searched + searched + withoutCorners);
  const std::size_t cornersOfParts = 2 * 3 * 2 * (2 * 2 + 3); // of a mesh in one buffer
  const std::size_t ofCurvilinearPicks = 2 * 2 * 3 * 2 * 3 * withoutCorners;
  const std::size_t ofLeavesPicked = 2 * 3 * 2 * ((2 + 1) * 2 + 3);
  const std::size_t ofLattices = 2 * 3 * 2 * ((3 + 2 + 2) * 2 * 2 + (2 + 1) + 2 * 2);
  const std::size_t ofTwoComponents = 2 * 3 * 2 * (2 * 2 * 2); // or more: never in two textures
  EXPECT_EQ(picked, 2 * ofTetrahedra + cornersOfParts + ofCurvilinearPicks + 3 * ofLattices -
                      ofTwoComponents + ofLeavesPicked);
  std::cout << "[ MEASURED ] " << legalKeys().size() << " variants of the picture, " << light
            << " of the light at vertices, " << picked << " of what is picked\n";
}

// Towards the light only extinction counts, and what stands in the way.
TEST(VariantKey, LightAtVerticesIsExtinctionAlone)
{
  for (const VariantKey& picture : legalKeys())
  {
    VariantKey light = picture.ofVertexLight(true);
    ASSERT_EQ(light.OpaqueShadows, picture.OpaqueShadows && !picture.SampledShadows);
    ASSERT_EQ(light.LightThroughCuts, picture.LightThroughCuts);
    ASSERT_EQ(light.Hierarchy, !picture.Structured);
    ASSERT_FALSE(picture.ofVertexLight(false).Hierarchy);
    light.OpaqueShadows = false;
    light.LightThroughCuts = false;
    ASSERT_TRUE(light == light.filtered());
    ASSERT_EQ(light.PointScalars, picture.PointScalars);
    ASSERT_EQ(light.Structured, picture.Structured);
    ASSERT_EQ(light.Rectilinear, picture.Rectilinear);
    ASSERT_EQ(light.Octree, picture.Octree);
    ASSERT_EQ(light.Leaps, picture.Leaps);
    ASSERT_EQ(light.HasFma, picture.HasFma);
    ASSERT_EQ(light.SplitCells, picture.SplitCells);
    ASSERT_EQ(light.Curvilinear, picture.Curvilinear);
    ASSERT_EQ(light.NanShown, picture.NanShown);
    ASSERT_EQ(light.HiddenCells, picture.HiddenCells);
    ASSERT_EQ(light.GradientOpacity, picture.GradientOpacity);
    ASSERT_EQ(light.CellGradients, picture.CellGradients && picture.GradientOpacity);
    ASSERT_FALSE(light.OpaqueDepth || light.Adaptive || light.Diagnostics || light.Shading ||
                 light.Clipped || light.Cropped || light.ShowIllumination || light.ShowGradients)
      << namesOf(light);
  }
}

// What is picked depends on what a ray gathers, but on no light, and ends at whatever else is
// drawn.
TEST(VariantKey, PicksKnowNoLight)
{
  for (const VariantKey& picture : legalKeys())
  {
    VariantKey pick = picture.ofPick();
    ASSERT_TRUE(pick == pick.filtered());
    ASSERT_TRUE(pick.OpaqueDepth);
    ASSERT_EQ(pick.PointScalars, picture.PointScalars);
    ASSERT_EQ(pick.GradientOpacity, picture.GradientOpacity);
    ASSERT_EQ(pick.CellGradients, picture.CellGradients && picture.GradientOpacity);
    const bool independent = picture.Components == ComponentGroup::Independent;
    ASSERT_EQ(pick.Components, independent ? ComponentGroup::Independent : ComponentGroup::Single);
    ASSERT_EQ(pick.Blend, picture.Blend);
    ASSERT_EQ(pick.Structured, picture.Structured);
    ASSERT_EQ(pick.Rectilinear, picture.Rectilinear);
    ASSERT_EQ(pick.Slabs, picture.Slabs);
    ASSERT_EQ(pick.ManySlabs, picture.ManySlabs);
    ASSERT_EQ(pick.Adaptive, pick.Structured && pick.PointScalars && pick.isComposite());
    pick.Adaptive = false;
    pick.PointScalars = true;
    pick.GradientOpacity = pick.CellGradients = false;
    pick.Components = ComponentGroup::Single;
    pick.Blend = BlendGroup::Composite;
    // Else there would be more samplers than a GL need have.
    ASSERT_EQ(
      pick.VisiblePart, picture.VisiblePart && !(picture.SplitCells && picture.CornerScalars));
    ASSERT_TRUE(pick.VisiblePart || !pick.Reentered); // its rays enter once more in that part alone
    pick.VisiblePart = false;
    pick.Reentered = false;
    for (bool VariantKey::*same :
      { &VariantKey::Clipped, &VariantKey::Cropped, &VariantKey::HiddenCells, &VariantKey::NanShown,
        &VariantKey::Octree, &VariantKey::Leaps, &VariantKey::SplitCells, &VariantKey::Curvilinear,
        &VariantKey::JoinedSides, &VariantKey::CornerScalars })
    {
      ASSERT_EQ(pick.*same, picture.*same) << namesOf(picture);
      pick.*same = false;
    }
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
    const VariantKey key = randomKey(random);
    VariantKey other = randomKey(random);
    other.EntryLists = key.EntryLists;
    other.Hierarchy = key.Hierarchy;
    other.OpaqueDepth = key.OpaqueDepth;
    other.HasFma = key.HasFma;
    other.Structured = key.Structured;
    other.Rectilinear = key.Rectilinear;
    other.Slabs = key.Slabs;
    other.ManySlabs = key.ManySlabs;
    const VariantKey entries = key.ofEntries();
    EXPECT_EQ(entries.defines(), other.ofEntries().defines());
    EXPECT_TRUE(entries == entries.filtered());
    const bool ofMesh = !key.Structured;
    EXPECT_EQ(entries.EntryLists, ofMesh && key.EntryLists);
    EXPECT_EQ(entries.Hierarchy, ofMesh && !key.EntryLists);
    EXPECT_EQ(entries.OpaqueDepth, key.OpaqueDepth);
    EXPECT_EQ(entries.HasFma, ofMesh && key.HasFma);
    EXPECT_EQ(entries.Structured, key.Structured);
    EXPECT_EQ(entries.Rectilinear, key.Structured && key.Rectilinear);
    EXPECT_FALSE(entries.Leaps);
    EXPECT_FALSE(entries.Clipped || entries.Cropped || entries.SplitCells);
    EXPECT_FALSE(entries.hasGradients() || entries.hasErrorBound());
    EXPECT_FALSE(entries.NanShown || entries.HiddenCells || entries.hasComponents());
  }
}
} // namespace
