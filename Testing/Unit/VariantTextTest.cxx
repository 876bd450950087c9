// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The texts of variants: nothing of what is off is left in it, nothing is declared in vain, and no
// two are the same.
#include "CoveringKeys.h"
#include "ShaderFeatures.h"
#include "ShaderWords.h"
#include "Variants/ShaderSource.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

namespace
{
using namespace tetmarch::testing;
using tetmarch::shaderSource;
using tetmarch::VariantKey;

class VariantText : public testing::Test
{
protected:
  VariantText()
  {
    for (const ShaderFeature& feature : shaderFeatures())
    {
      this->Features.push_back({ &feature, this->numbersOf(feature.Words) });
      this->Claimed.insert(this->Features.back().Words.begin(), this->Features.back().Words.end());
    }
    const std::vector<int> unused = this->numbersOf(UnusedInSome);
    this->MayBeUnused.insert(unused.begin(), unused.end());
  }

  std::vector<int> numbersOf(const char* words)
  {
    std::vector<int> numbers;
    std::istringstream stream(words);
    for (std::string word; stream >> word;)
    {
      numbers.push_back(this->Words.numberOf(word));
    }
    return numbers;
  }

  // Texts of all variants of one shader.
  void expectClean(const std::vector<VariantKey>& keys, MarchShader shader, const char* file)
  {
    std::set<std::uint64_t> texts;
    for (const VariantKey& key : keys)
    {
      this->Words.read(shaderSource(file, key.defines()));
      ASSERT_EQ(this->Words.leftover(), "") << namesOf(key);
      ASSERT_NO_FATAL_FAILURE(this->expectFeatures(key, shader));
      ASSERT_NO_FATAL_FAILURE(this->expectUse(key));
      ASSERT_TRUE(texts.insert(this->Words.fingerprint()).second)
        << namesOf(key) << " has the text of another variant";
    }
    // What only some variants declare belongs to a feature.
    for (const auto& [word, times] : this->Declared)
    {
      EXPECT_TRUE(times == keys.size() || this->Claimed.count(word) == 1)
        << this->Words.word(word) << " is declared in " << times << " of " << keys.size();
    }
  }

  void expectFeatures(const VariantKey& key, MarchShader shader)
  {
    for (const auto& [feature, words] : this->Features)
    {
      const bool on = feature->IsOn(key, shader);
      for (int word : words)
      {
        ASSERT_EQ(this->Words.count(word) > 0, on)
          << this->Words.word(word) << " of " << feature->Name << ", in " << namesOf(key);
      }
    }
  }

  void expectUse(const VariantKey& key)
  {
    for (int uniform : this->Words.uniforms())
    {
      ++this->Declared[uniform];
      ASSERT_GT(this->Words.count(uniform), 1)
        << this->Words.word(uniform) << ", in " << namesOf(key);
    }
    for (int function : this->Words.functions())
    {
      ++this->Declared[function];
      const bool used = this->Words.count(function) > 1;
      ASSERT_TRUE(used || this->MayBeUnused.count(function) == 1)
        << this->Words.word(function) << ", in " << namesOf(key);
      if (!used)
      {
        this->Unused.insert(function);
      }
    }
  }

  struct Feature
  {
    const ShaderFeature* Row;
    std::vector<int> Words;
  };

  ShaderWords Words;
  std::vector<Feature> Features;
  std::set<int> Claimed;
  std::set<int> MayBeUnused;
  std::set<int> Unused;
  std::map<int, std::size_t> Declared; // functions and uniforms, in how many texts
};

// Opaque geometry's shadows are part of the light at vertices. Where all light is, the picture
// knows nothing of them.
bool hasTextOfItsOwn(const VariantKey& picture)
{
  return !picture.OpaqueShadows || picture.SampledShadows;
}

TEST_F(VariantText, OfThePicture)
{
  std::vector<VariantKey> keys = legalKeys();
  keys.erase(std::partition(keys.begin(), keys.end(), hasTextOfItsOwn), keys.end());
  this->expectClean(keys, MarchShader::Picture, "passes/march.frag.glsl");
}

TEST_F(VariantText, OfOpaqueShadowsAtVertices)
{
  int compared = 0;
  for (VariantKey key : legalKeys())
  {
    if (!hasTextOfItsOwn(key))
    {
      const std::string text = shaderSource("passes/march.frag.glsl", key.defines());
      key.OpaqueShadows = false;
      ASSERT_EQ(text, shaderSource("passes/march.frag.glsl", key.defines())) << namesOf(key);
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST_F(VariantText, OfTheLightAtVertices)
{
  this->expectClean(legalLightKeys(), MarchShader::LightAtVertex, "passes/vertex_light.frag.glsl");
}

TEST_F(VariantText, OfWhatIsPicked)
{
  this->expectClean(legalPickKeys(), MarchShader::Pick, "passes/pick.frag.glsl");
}

// Functions and uniforms of the files of one folder that no other folder has.
std::set<int> ownWordsOf(const std::string& folder, ShaderWords& words)
{
  namespace fs = std::filesystem;
  std::set<int> own;
  std::set<int> others;
  for (const auto& entry : fs::recursive_directory_iterator(TETMARCH_SHADER_DIR))
  {
    if (entry.path().extension() == ".glsl")
    {
      std::ifstream file(entry.path());
      words.read(std::string(std::istreambuf_iterator<char>(file), {}));
      std::set<int>& into = entry.path().parent_path().filename() == folder ? own : others;
      into.insert(words.functions().begin(), words.functions().end());
      into.insert(words.uniforms().begin(), words.uniforms().end());
    }
  }
  for (int word : others)
  {
    own.erase(word);
  }
  return own;
}

TEST_F(VariantText, OfOneKindOfVolumeHasNothingOfAnother)
{
  const std::set<int> ofMeshes = ownWordsOf("tet", this->Words);
  const std::set<int> ofLattices = ownWordsOf("structured", this->Words);
  EXPECT_GT(ofMeshes.size(), 30u);
  EXPECT_GT(ofLattices.size(), 30u);
  std::set<int> found;
  const auto expectOneKind = [&](const std::vector<VariantKey>& keys, const char* file)
  {
    for (const VariantKey& key : keys)
    {
      this->Words.read(shaderSource(file, key.defines() + "#define TETMARCH_HAS_GATHER 1\n"));
      for (int word : key.Structured ? ofMeshes : ofLattices)
      {
        ASSERT_EQ(this->Words.count(word), 0) << this->Words.word(word) << ", in " << namesOf(key);
      }
      for (int word : key.Structured ? ofLattices : ofMeshes)
      {
        if (this->Words.count(word) > 0)
        {
          found.insert(word);
        }
      }
    }
  };
  expectOneKind(coveringKeys(legalKeys()), "passes/march.frag.glsl");
  expectOneKind(legalPickKeys(), "passes/pick.frag.glsl");
  expectOneKind(coveringVisitKeys(), "passes/visit.frag.glsl");
  expectOneKind(legalLightKeys(), "passes/vertex_light.frag.glsl");
  for (const std::set<int>& words : { ofMeshes, ofLattices })
  {
    for (int word : words)
    {
      EXPECT_EQ(found.count(word), 1u) << this->Words.word(word) << " is in no text";
    }
  }
}

// The tables of the test itself: words that no text has would let anything pass.
TEST_F(VariantText, TablesAreOfWordsThatThereAre)
{
  std::set<int> found;
  const auto look = [&](const VariantKey& key, const char* file)
  {
    this->Words.read(shaderSource(file, key.defines()));
    this->expectUse(key);
    for (int word : this->Claimed)
    {
      if (this->Words.count(word) > 0)
      {
        found.insert(word);
      }
    }
  };
  for (const VariantKey& key : legalKeys())
  {
    look(key, "passes/march.frag.glsl");
  }
  for (const VariantKey& key : legalLightKeys())
  {
    look(key, "passes/vertex_light.frag.glsl");
  }
  for (const VariantKey& key : legalPickKeys())
  {
    look(key, "passes/pick.frag.glsl");
  }
  for (int word : this->Claimed)
  {
    EXPECT_EQ(found.count(word), 1u) << this->Words.word(word);
  }
  EXPECT_EQ(this->Unused, this->MayBeUnused);
}
} // namespace
