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
#include <cstddef>
#include <random>
#include <vector>

namespace tetmarch::testing
{
constexpr std::size_t NumberOfThrees = []
{
  constexpr std::size_t n = VariantKey::NumberOfFeatures;
  return 8 * n * (n - 1) * (n - 2) / 6;
}();

/// Calls with a number for each three features of the key, by which of them are on.
template <typename Function>
void forEachThree(const VariantKey& key, const Function& call)
{
  const std::uint64_t bits = key.bits();
  const auto bit = [bits](int i)
  { return std::size_t((bits & VariantKey::features()[i].Bit) != 0 ? 1 : 0); };
  std::size_t three = 0;
  for (int a = 0; a < VariantKey::NumberOfFeatures; ++a)
  {
    for (int b = 0; b < a; ++b)
    {
      for (int c = 0; c < b; ++c)
      {
        call(8 * three + 4 * bit(a) + 2 * bit(b) + bit(c));
        ++three;
      }
    }
  }
}

/// Those that bring most first, not among all of them, and in the end whatever brings anything. The
/// same at each call.
inline std::vector<VariantKey> coveringKeys(std::vector<VariantKey> legal)
{
  std::mt19937 random(1);
  for (std::size_t i = legal.size(); i > 1; --i)
  {
    std::swap(legal[i - 1], legal[random() % i]);
  }
  std::vector<VariantKey> chosen;
  std::vector<bool> covered(NumberOfThrees, false);
  constexpr std::size_t few = 1000;
  for (int least = 4096; least > 0; least /= 2)
  {
    const std::size_t candidates = least > 1 ? std::min(few, legal.size()) : legal.size();
    for (std::size_t i = 0; i < candidates; ++i)
    {
      int news = 0;
      forEachThree(legal[i], [&](std::size_t three) { news += covered[three] ? 0 : 1; });
      if (news >= least)
      {
        chosen.push_back(legal[i]);
        forEachThree(legal[i], [&](std::size_t three) { covered[three] = true; });
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
