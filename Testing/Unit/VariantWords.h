// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How the words of a shader's text change when a feature of its key is switched.
#ifndef tetmarch_testing_VariantWords_h
#define tetmarch_testing_VariantWords_h

#include "Variants/VariantKey.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tetmarch::testing
{
class VariantWords
{
public:
  /// The words of one text of the shader, in ascending order.
  void add(const VariantKey& key, std::vector<int> words)
  {
    this->Texts.emplace(key.bits(), std::move(words));
  }

  /// The words that only some texts have, by the features on which they depend:
  ///   +NAME  no text without the feature has the word
  ///   -NAME  no text with the feature has the word
  ///   ~NAME  texts with and without the feature have it, but switching the feature alone brings or
  ///          removes it somewhere
  /// A feature that can be switched alone is named only if that brings or removes the word.
  std::map<std::string, std::vector<int>> byFeatures() const;

private:
  std::map<std::uint64_t, std::vector<int>> Texts; // by the bits of their keys
};
} // namespace tetmarch::testing

#endif
