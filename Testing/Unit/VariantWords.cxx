// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VariantWords.h"

#include <algorithm>
#include <iterator>

namespace tetmarch::testing
{
namespace
{
constexpr std::uint64_t All = ~std::uint64_t(0);

struct Dependence
{
  std::size_t Texts = 0;     // that have the word
  std::uint64_t Needs = All; // features of all these texts
  std::uint64_t Lacks = All; // features of none of these texts
  std::uint64_t Changes = 0; // features that bring or remove the word
};
} // namespace

std::map<std::string, std::vector<int>> VariantWords::byFeatures() const
{
  std::map<int, Dependence> found;
  Dependence any;
  std::vector<int> changed;
  for (const auto& [bits, words] : this->Texts)
  {
    any.Needs &= bits;
    any.Lacks &= ~bits;
    for (const int word : words)
    {
      Dependence& of = found[word];
      ++of.Texts;
      of.Needs &= bits;
      of.Lacks &= ~bits;
    }
    for (const VariantKey::Feature& feature : VariantKey::features())
    {
      const auto without = this->Texts.find(bits & ~feature.Bit);
      if ((bits & feature.Bit) != 0 && without != this->Texts.end())
      {
        any.Changes |= feature.Bit;
        changed.clear();
        std::set_symmetric_difference(words.begin(), words.end(), without->second.begin(),
          without->second.end(), std::back_inserter(changed));
        for (const int word : changed)
        {
          found[word].Changes |= feature.Bit;
        }
      }
    }
  }
  std::map<std::string, std::vector<int>> byFeatures;
  for (const auto& [word, of] : found)
  {
    std::string names;
    const std::uint64_t named =
      of.Changes | ((of.Needs | of.Lacks) & ~(any.Needs | any.Lacks | any.Changes));
    for (const VariantKey::Feature& feature : VariantKey::features())
    {
      const char* sign = of.Needs & feature.Bit ? " +" : of.Lacks & feature.Bit ? " -" : " ~";
      names += named & feature.Bit ? sign + std::string(feature.Name) : std::string();
    }
    if (of.Texts < this->Texts.size())
    {
      byFeatures[names].push_back(word);
    }
  }
  return byFeatures;
}
} // namespace tetmarch::testing
