// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A few variants that have every three features together or apart, as far as any variant has
 *
 * Where a text doesn't fit together, it is for a few features that meet.
 */
#ifndef tetmarch_testing_CoveringKeys_h
#define tetmarch_testing_CoveringKeys_h

#include "LegalKeys.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace tetmarch::testing
{
/// Which settings of any two features there are among keys.
class Twos
{
public:
  /// How many of the key's are not among them.
  int numberOfNew(const VariantKey& key) const
  {
    const std::uint64_t bits = key.bits();
    int found = 0;
    for (int i = 0; i < VariantKey::NumberOfFeatures; ++i)
    {
      const std::size_t state = 2 * i + (bits >> i & 1);
      found += static_cast<int>(std::bitset<64>(bits & ~this->On[state]).count() +
                                std::bitset<64>(~bits & ~this->Off[state]).count());
    }
    return found;
  }
  void add(const VariantKey& key)
  {
    const std::uint64_t bits = key.bits();
    for (int i = 0; i < VariantKey::NumberOfFeatures; ++i)
    {
      const std::size_t state = 2 * i + (bits >> i & 1);
      this->On[state] |= bits;
      this->Off[state] |= ~bits;
    }
  }
  bool operator==(const Twos& other) const
  {
    return this->On == other.On && this->Off == other.Off;
  }

private:
  std::array<std::uint64_t, std::size_t(2)* VariantKey::NumberOfFeatures> On = {};
  std::array<std::uint64_t, std::size_t(2)* VariantKey::NumberOfFeatures> Off = {};
};

/// Which settings of any three features there are among keys.
class Threes
{
public:
  /// How many of the key's are not among them.
  int numberOfNew(const VariantKey& key) const
  {
    int found = 0;
    forEachPair(key,
      [&](std::size_t pair, std::uint64_t on, std::uint64_t off)
      {
        found += static_cast<int>(std::bitset<64>(on & ~this->On[pair]).count() +
                                  std::bitset<64>(off & ~this->Off[pair]).count());
      });
    return found;
  }
  void add(const VariantKey& key)
  {
    forEachPair(key,
      [&](std::size_t pair, std::uint64_t on, std::uint64_t off)
      {
        this->On[pair] |= on;
        this->Off[pair] |= off;
      });
  }
  bool operator==(const Threes& other) const
  {
    return this->On == other.On && this->Off == other.Off;
  }

private:
  // Calls with a number for two features and which of them are on, and with the bits of those
  // before them that are on and off.
  template <typename Function>
  static void forEachPair(const VariantKey& key, const Function& call)
  {
    const std::uint64_t bits = key.bits();
    std::size_t pair = 0;
    for (int a = 0; a < VariantKey::NumberOfFeatures; ++a)
    {
      for (int b = 0; b < a; ++b, pair += 4)
      {
        const std::uint64_t before = (std::uint64_t(1) << b) - 1;
        call(pair + 2 * (bits >> a & 1) + (bits >> b & 1), bits & before, ~bits & before);
      }
    }
  }
  static constexpr std::size_t NumberOfPairs =
    2 * VariantKey::NumberOfFeatures * (VariantKey::NumberOfFeatures - 1);
  std::array<std::uint64_t, NumberOfPairs> On = {};
  std::array<std::uint64_t, NumberOfPairs> Off = {};
};

/// Those that bring most Settings first, not among all of them, and in the end whatever brings any.
/// The same at each call.
template <typename Settings = Threes>
std::vector<VariantKey> coveringKeys(std::vector<VariantKey> legal)
{
  std::mt19937 random(1);
  for (std::size_t i = legal.size(); i > 1; --i)
  {
    std::swap(legal[i - 1], legal[random() % i]);
  }
  std::vector<VariantKey> chosen;
  Settings covered;
  constexpr std::size_t few = 1000;
  for (int least = 4096; least > 0; least /= 2)
  {
    const std::size_t candidates = least > 1 ? std::min(few, legal.size()) : legal.size();
    for (std::size_t i = 0; i < candidates; ++i)
    {
      if (covered.numberOfNew(legal[i]) >= least)
      {
        chosen.push_back(legal[i]);
        covered.add(legal[i]);
      }
    }
  }
  return chosen;
}

/// Of passes/visit.frag.glsl, which is for the picture of a mesh alone.
inline std::vector<VariantKey> coveringVisitKeys()
{
  std::vector<VariantKey> keys = coveringKeys(legalKeys());
  const auto hasNoVisits = [](const VariantKey& key)
  { return key.Structured || key.Peeled || key.Diagnostics; };
  keys.erase(std::remove_if(keys.begin(), keys.end(), hasNoVisits), keys.end());
  return keys;
}
} // namespace tetmarch::testing

#endif
