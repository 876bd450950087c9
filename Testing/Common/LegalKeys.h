// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief All variants of the march shader that a scene can need
 */
#ifndef tetmarch_testing_LegalKeys_h
#define tetmarch_testing_LegalKeys_h

#include "Scene/VariantKey.h"

#include <string>
#include <vector>

namespace tetmarch::testing
{
constexpr unsigned int NumberOfKeys = 1u << VariantKey::NumberOfBits;

/// Bit i of the number is row i of VariantKey::bits().
inline VariantKey keyOf(unsigned int number)
{
  VariantKey key;
  unsigned int rest = number;
  for (const VariantKey::Bit& bit : VariantKey::bits())
  {
    key.*bit.Member = (rest & 1u) != 0;
    rest >>= 1;
  }
  return key;
}

inline unsigned int numberOf(const VariantKey& key)
{
  unsigned int number = 0;
  for (int i = 0; i < VariantKey::NumberOfBits; ++i)
  {
    number |= (key.*VariantKey::bits()[i].Member ? 1u : 0u) << i;
  }
  return number;
}

/// Names of the bits that are set.
inline std::string namesOf(const VariantKey& key)
{
  std::string names;
  for (const VariantKey::Bit& bit : VariantKey::bits())
  {
    names += key.*bit.Member ? (names.empty() ? "" : " ") + std::string(bit.Name) : std::string();
  }
  return names;
}

/// Keys in the order in which they come, each once.
class DistinctKeys
{
public:
  void add(const VariantKey& key)
  {
    if (!this->Found[numberOf(key)])
    {
      this->Found[numberOf(key)] = true;
      this->Keys.push_back(key);
    }
  }
  std::vector<VariantKey> Keys;

private:
  std::vector<bool> Found = std::vector<bool>(NumberOfKeys, false);
};

/// Of the picture. Some scene makes each of them: the filter leaves none that none could.
inline std::vector<VariantKey> legalKeys()
{
  DistinctKeys legal;
  for (unsigned int number = 0; number < NumberOfKeys; ++number)
  {
    legal.add(keyOf(number).filtered());
  }
  return legal.Keys;
}

/// Of the light at vertices, for the pictures that have it.
inline std::vector<VariantKey> legalLightKeys()
{
  DistinctKeys legal;
  for (const VariantKey& key : legalKeys())
  {
    if (key.hasVertexLight())
    {
      legal.add(key.ofVertexLight());
    }
  }
  return legal.Keys;
}

/// Of what is picked.
inline std::vector<VariantKey> legalPickKeys()
{
  DistinctKeys legal;
  for (const VariantKey& key : legalKeys())
  {
    legal.add(key.ofPick());
  }
  return legal.Keys;
}
} // namespace tetmarch::testing

#endif
