// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Variants of the march shader that a scene can need
 */
#ifndef tetmarch_testing_LegalKeys_h
#define tetmarch_testing_LegalKeys_h

#include "Variants/VariantKey.h"

#include <cstdint>
#include <random>
#include <string>
#include <unordered_set>
#include <vector>

namespace tetmarch::testing
{
/// The key with these features, and no others; of several values of a group it has the first.
inline VariantKey keyOf(std::uint64_t bits)
{
  VariantKey key;
  const auto& features = VariantKey::features();
  for (auto feature = features.rbegin(); feature != features.rend(); ++feature)
  {
    feature->set(key, (bits & feature->Bit) != 0);
  }
  return key;
}

/// Names of the features that are on.
inline std::string namesOf(const VariantKey& key)
{
  std::string names;
  for (const VariantKey::Feature& feature : VariantKey::features())
  {
    names +=
      feature.isOn(key) ? (names.empty() ? "" : " ") + std::string(feature.Name) : std::string();
  }
  return names;
}

/// Any combination of features, whether or not a scene makes it.
inline VariantKey randomKey(std::mt19937& random)
{
  const std::uint64_t high = random();
  return keyOf(high << 32 | random());
}

/// Keys in the order in which they come, each once.
class DistinctKeys
{
public:
  void add(const VariantKey& key)
  {
    if (this->Found.insert(key.bits()).second)
    {
      this->Keys.push_back(key);
    }
  }
  std::vector<VariantKey> Keys;

private:
  std::unordered_set<std::uint64_t> Found;
};

/// Of the picture, for there are millions: those of the simplest scenes of tetrahedra and of a
/// lattice, what they become by up to three changes of a feature, and many at random. Some scene
/// makes each of them: the filter leaves none that none could. The same at each call.
inline std::vector<VariantKey> legalKeys()
{
  DistinctKeys legal;
  VariantKey simplest;
  legal.add(simplest.filtered());
  simplest.Structured = true;
  legal.add(simplest.filtered());
  std::size_t begin = 0;
  for (int changes = 0; changes < 3; ++changes)
  {
    const std::size_t end = legal.Keys.size();
    for (; begin < end; ++begin)
    {
      for (const VariantKey::Feature& feature : VariantKey::features())
      {
        VariantKey key = legal.Keys[begin];
        feature.set(key, !feature.isOn(key));
        legal.add(key.filtered());
      }
    }
  }
  std::mt19937 random(5);
  for (int i = 0; i < 160000; ++i)
  {
    VariantKey key = randomKey(random);
    if (i % 4 > 0) // else the volume itself would be seen in one of eight
    {
      key.Blend = BlendGroup::Composite;
    }
    if (i % 4 != 1) // else seven of eight would have several scalars
    {
      key.Components = ComponentGroup::Single;
    }
    if (i % 8 < 4) // else half would be of lattices, which have fewer features
    {
      key.Structured = false;
    }
    if (i % 8 != 2) // else half would have no corners of their own
    {
      key.Curvilinear = false;
    }
    legal.add(key.filtered());
    if (i % 8 > 3) // else few would be of lattices without leaves, or with them
    {
      key.Octree = !key.Octree;
      legal.add(key.filtered());
    }
  }
  return legal.Keys;
}

/// Of the light at vertices, for the pictures that have it; in whatever number of slabs, or of
/// buffers of tetrahedra, through cuts or not, and past opaque geometry or not.
inline std::vector<VariantKey> legalLightKeys()
{
  DistinctKeys legal;
  for (const VariantKey& picture : legalKeys())
  {
    if (picture.hasVertexLight())
    {
      for (int bits = 0; bits < 8; ++bits)
      {
        const bool reenters = bits & 1;
        VariantKey key = picture;
        key.LightThroughCuts = bits & 2;
        key.OpaqueShadows = bits & 4;
        legal.add(key.ofVertexLight(reenters));
        key.Slabs = key.Structured;
        key.ManySlabs = false;
        legal.add(key.ofVertexLight(reenters));
        key.ManySlabs = key.Structured;
        legal.add(key.ofVertexLight(reenters));
        key.SplitCells = !key.SplitCells;
        legal.add(key.ofVertexLight(reenters));
      }
    }
  }
  return legal.Keys;
}

/// Of what is picked; in whatever number of buffers of tetrahedra, or computed ones.
inline std::vector<VariantKey> legalPickKeys()
{
  DistinctKeys legal;
  for (const VariantKey& key : legalKeys())
  {
    legal.add(key.ofPick());
    VariantKey other = key;
    other.SplitCells = !key.SplitCells;
    legal.add(other.ofPick());
    other.Curvilinear = true;
    legal.add(other.ofPick());
    other.JoinedSides = true;
    legal.add(other.ofPick());
  }
  return legal.Keys;
}
} // namespace tetmarch::testing

#endif
