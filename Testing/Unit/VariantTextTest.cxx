// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The texts of variants, and what of them changes when a feature is switched: nothing of what is
// off is left, nothing is declared in vain, no two are the same, and each kind of volume has its
// own. The words that come and go with features are listed in variant_words.txt.
#include "CoveringKeys.h"
#include "ShaderWords.h"
#include "VariantWords.h"
#include "Variants/ShaderSource.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <iterator>
#include <map>
#include <set>

namespace
{
using namespace tetmarch::testing;
using tetmarch::shaderSource;
using tetmarch::VariantKey;

constexpr char ListName[] = TETMARCH_SOURCE_DIR "/Testing/Unit/variant_words.txt";
constexpr char Gather[] = "#define TETMARCH_HAS_GATHER 1\n";

/// Any four features together and apart, as far as any variant has them so: of any three some key
/// tells, and of each key the fourth is switched.
std::vector<VariantKey> switchedKeys()
{
  DistinctKeys keys;
  for (const VariantKey& key : coveringKeys(legalKeys()))
  {
    keys.add(key);
    for (const VariantKey::Feature& feature : VariantKey::features())
    {
      VariantKey switched = key;
      feature.set(switched, !feature.isOn(key));
      keys.add(switched.filtered());
    }
  }
  return keys.Keys;
}

/// The key that has the same text: where opaque geometry's shadows, and cuts that light passes
/// through, are part of the light at vertices, the picture knows nothing of them.
VariantKey ofSameText(VariantKey key, const std::string& file)
{
  const bool marchesToLight = key.SampledShadows || file == "passes/vertex_light.frag.glsl";
  key.OpaqueShadows = key.OpaqueShadows && marchesToLight;
  key.LightThroughCuts = key.LightThroughCuts && marchesToLight;
  return key;
}

class VariantText : public testing::Test
{
protected:
  VariantText()
    : OfMeshes(this->ownWordsOf("tet"))
    , OfLattices(this->ownWordsOf("structured"))
  {
    EXPECT_GT(this->OfMeshes.size(), 30u);
    EXPECT_GT(this->OfLattices.size(), 30u);
  }

  /// Functions and uniforms of the files of one folder that no other folder has.
  std::set<int> ownWordsOf(const std::string& folder)
  {
    namespace fs = std::filesystem;
    std::set<int> own;
    std::set<int> others;
    for (const auto& entry : fs::recursive_directory_iterator(TETMARCH_SHADER_DIR))
    {
      if (entry.path().extension() == ".glsl")
      {
        std::ifstream file(entry.path());
        this->Words.read(std::string(std::istreambuf_iterator<char>(file), {}));
        std::set<int>& into = entry.path().parent_path().filename() == folder ? own : others;
        into.insert(this->Words.functions().begin(), this->Words.functions().end());
        into.insert(this->Words.uniforms().begin(), this->Words.uniforms().end());
      }
    }
    for (const int word : others)
    {
      own.erase(word);
    }
    return own;
  }

  /// Texts of one shader, and their words.
  void read(const char* file, const std::vector<VariantKey>& keys, const std::string& defines,
    VariantWords& found)
  {
    std::map<std::uint64_t, std::uint64_t> keysOfTexts;
    std::map<std::uint64_t, std::uint64_t> textsOfKeys;
    for (const VariantKey& key : keys)
    {
      this->Words.read(shaderSource(file, key.defines() + defines));
      ASSERT_EQ(this->Words.leftover(), "") << namesOf(key);
      ASSERT_NO_FATAL_FAILURE(this->expectUse(key));
      ASSERT_NO_FATAL_FAILURE(this->expectOneKind(key));
      found.add(key, this->Words.declared());
      const std::uint64_t text = this->Words.fingerprint();
      const std::uint64_t own = ofSameText(key, file).bits();
      ASSERT_EQ(keysOfTexts.emplace(text, own).first->second, own)
        << namesOf(key) << " has the text of another variant";
      ASSERT_EQ(textsOfKeys.emplace(own, text).first->second, text)
        << namesOf(key) << " has another text than without shadows of opaque geometry or cuts of light";
    }
  }

  /// The same, and adds to the list on which features the words depend.
  void list(const char* file, const std::vector<VariantKey>& keys)
  {
    VariantWords found;
    ASSERT_NO_FATAL_FAILURE(this->read(file, keys, "", found));
    this->List.emplace_back(file);
    for (const auto& [features, words] : found.byFeatures())
    {
      this->addLines(features + ':', words);
    }
  }

  void expectUse(const VariantKey& key)
  {
    for (const int uniform : this->Words.uniforms())
    {
      ASSERT_GT(this->Words.count(uniform), 1)
        << this->Words.word(uniform) << ", in " << namesOf(key);
    }
    for (const int function : this->Words.functions())
    {
      if (this->Words.count(function) == 1)
      {
        this->Unused.insert(function);
      }
    }
  }

  void expectOneKind(const VariantKey& key)
  {
    for (const int word : key.Structured ? this->OfMeshes : this->OfLattices)
    {
      ASSERT_EQ(this->Words.count(word), 0) << this->Words.word(word) << ", in " << namesOf(key);
    }
    std::set<int>& unseen = key.Structured ? this->UnseenOfLattices : this->UnseenOfMeshes;
    for (auto word = unseen.begin(); word != unseen.end();)
    {
      word = this->Words.count(*word) > 0 ? unseen.erase(word) : std::next(word);
    }
  }

  /// Words in alphabetical order, in lines of a page's width.
  void addLines(std::string line, const std::vector<int>& words)
  {
    std::set<std::string> sorted;
    for (const int word : words)
    {
      sorted.insert(this->Words.word(word));
    }
    for (const std::string& word : sorted)
    {
      if (line.size() + word.size() > 118)
      {
        this->List.push_back(line);
        line = "   ";
      }
      line += ' ' + word;
    }
    this->List.push_back(line);
  }

  ShaderWords Words;
  const std::set<int> OfMeshes;
  const std::set<int> OfLattices;
  std::set<int> UnseenOfMeshes = OfMeshes;
  std::set<int> UnseenOfLattices = OfLattices;
  std::set<int> Unused; // functions that stay beside those that are used, in one file
  std::vector<std::string> List;
};

TEST_F(VariantText, ChangesWithItsFeatures)
{
  ASSERT_NO_FATAL_FAILURE(this->list("passes/march.frag.glsl", switchedKeys()));
  ASSERT_NO_FATAL_FAILURE(this->list("passes/vertex_light.frag.glsl", legalLightKeys()));
  ASSERT_NO_FATAL_FAILURE(this->list("passes/pick.frag.glsl", legalPickKeys()));
  VariantWords extra;
  ASSERT_NO_FATAL_FAILURE(this->read("passes/visit.frag.glsl", coveringVisitKeys(), "", extra));
  std::vector<VariantKey> trilinear = coveringKeys(legalPickKeys());
  trilinear.erase(std::remove_if(trilinear.begin(), trilinear.end(),
                    [](const VariantKey& key) { return !key.Structured || !key.PointScalars; }),
    trilinear.end());
  ASSERT_NO_FATAL_FAILURE(this->read("passes/pick.frag.glsl", trilinear, Gather, extra));
  for (const std::set<int>* unseen : { &this->UnseenOfMeshes, &this->UnseenOfLattices })
  {
    for (const int word : *unseen)
    {
      ADD_FAILURE() << this->Words.word(word) << " is in no text";
    }
  }
  this->List.push_back("functions that some texts have in vain");
  this->addLines("   ", { this->Unused.begin(), this->Unused.end() });

  if (std::getenv("TETMARCH_WRITE_VARIANT_WORDS"))
  {
    std::ofstream file(ListName);
    std::copy(this->List.begin(), this->List.end(), std::ostream_iterator<std::string>(file, "\n"));
    return;
  }
  std::ifstream file(ListName);
  std::multiset<std::string> listed;
  for (std::string line; std::getline(file, line);)
  {
    listed.insert(line);
  }
  for (const std::string& line : this->List)
  {
    const auto same = listed.find(line);
    EXPECT_TRUE(same != listed.end()) << "not in " << ListName << ":\n" << line;
    if (same != listed.end())
    {
      listed.erase(same);
    }
  }
  for (const std::string& line : listed)
  {
    ADD_FAILURE() << "no longer so:\n" << line;
  }
  if (testing::Test::HasFailure())
  {
    std::cout << "If that is meant, run the test with TETMARCH_WRITE_VARIANT_WORDS=1 in the "
                 "environment and read what it has changed in the file.\n";
  }
}
} // namespace
