// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Khronos' reference compiler takes the texts of the variants that VariantBuildTest builds, and
// those of all other passes, as GLSL 4.50 core: a second opinion beside the GL at hand, which may
// take what the language does not have.
#include "CoreGlsl.h"
#include "CoveringKeys.h"
#include "Variants/ShaderSource.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <map>
#include <memory>
#include <regex>
#include <set>

namespace
{
using namespace tetmarch::testing;
using tetmarch::shaderSource;
using tetmarch::VariantKey;
using tetmarch::withFileNames;

namespace fs = std::filesystem;

// How many structs lie in each other at most.
int depthOfStructs(const std::string& text)
{
  std::map<std::string, int> depths;
  int most = 0;
  static const std::regex declaration("struct (\\w+)\\s*\\{([^}]*)\\}");
  static const std::regex member("(\\w+) \\w+(?:\\[\\d+\\])?;");
  for (std::sregex_iterator at(text.begin(), text.end(), declaration), end; at != end; ++at)
  {
    const std::string members = (*at)[2];
    int depth = 1;
    for (std::sregex_iterator of(members.begin(), members.end(), member); of != end; ++of)
    {
      const auto known = depths.find((*of)[1]);
      depth = std::max(depth, known == depths.end() ? 1 : known->second + 1);
    }
    depths[(*at)[1]] = depth;
    most = std::max(most, depth);
  }
  return most;
}

class GlslValidator : public testing::Test
{
protected:
  void SetUp() override
  {
    if (std::string(TETMARCH_GLSLANG_VALIDATOR).empty())
    {
      GTEST_SKIP() << "CMake found no glslangValidator (Debian's glslang-tools)";
    }
    this->Folder =
      fs::temp_directory_path() / ("tetmarch-glsl-" + std::to_string(std::random_device()()));
    fs::create_directory(this->Folder);
  }

  void TearDown() override
  {
    if (!this->Folder.empty())
    {
      fs::remove_all(this->Folder);
    }
  }

  void add(const std::string& file, const std::string& defines, const std::string& variant)
  {
    this->addText(file, asCoreGlsl(shaderSource(file, defines)), variant);
  }

  void addText(const std::string& file, const std::string& text, const std::string& variant)
  {
    const std::string stage = file.substr(file.find('.'), 5); // .vert, .frag or .comp
    const std::string name = std::to_string(this->Variants.size()) + stage;
    std::ofstream(this->Folder / name) << text;
    this->Variants[name] = file + " of " + variant;
  }

  // In GLSL ES 3.00, as a page has the variants of pictures.
  void addForPages(const std::string& file, VariantKey key, const std::string& defined = {})
  {
    key.Peeled = false;
    key.SplitCells = false;
    key.HasFma = false;
    key = key.filtered();
    const std::string defines = key.defines() + "#define TETMARCH_ES 1\n" + defined;
    const std::string text = asWebGlsl(shaderSource(file, defines));
    this->addText(file, text, namesOf(key) + ", for pages");
    EXPECT_LE(depthOfStructs(text), 4) << file << " of " << namesOf(key); // the limit of WebGL
  }

  // In one run of the validator, which names each file before what it says of it.
  void expectValid() const
  {
    ASSERT_FALSE(this->Variants.empty());
    const std::string command =
      "cd '" + this->Folder.string() + "' && '" TETMARCH_GLSLANG_VALIDATOR "' * 2>&1";
    std::unique_ptr<FILE, int (*)(FILE*)> output(popen(command.c_str(), "r"), pclose);
    ASSERT_TRUE(output);
    std::string variant;
    std::set<std::string> read;
    int messages = 0;
    char line[4096];
    while (fgets(line, sizeof(line), output.get()) && messages < 20)
    {
      std::string text = line;
      text.erase(text.find_last_not_of("\r\n") + 1);
      if (this->Variants.count(text) > 0)
      {
        variant = this->Variants.at(text);
        read.insert(text);
      }
      else if (!text.empty())
      {
        ADD_FAILURE() << withFileNames(text) << "\n  in " << variant;
        ++messages;
      }
    }
    EXPECT_TRUE(messages >= 20 || read.size() == this->Variants.size());
  }

  void expectVariants(const char* file, const std::vector<VariantKey>& keys)
  {
    for (const VariantKey& key : keys)
    {
      this->add(file, key.defines(), namesOf(key));
      if (key.Structured)
      {
        this->add(file, key.defines() + Gather, namesOf(key) + ", with gather");
      }
    }
    this->expectValid();
    std::cout << "[ MEASURED ] " << file << ": " << keys.size() << " variants\n";
  }

  // What a driver defines that has the extension.
  static constexpr const char* Gather = "#define TETMARCH_HAS_GATHER 1\n";

  fs::path Folder;
  std::map<std::string, std::string> Variants; // by file
};

TEST_F(GlslValidator, TakesThePicture)
{
  this->expectVariants("passes/march.frag.glsl", coveringKeys(legalKeys()));
}

TEST_F(GlslValidator, TakesThePictureByCompute)
{
  std::vector<VariantKey> keys = coveringKeys(legalKeys());
  const auto isPeeled = [](const VariantKey& key) { return key.Peeled; };
  keys.erase(std::remove_if(keys.begin(), keys.end(), isPeeled), keys.end());
  this->expectVariants("passes/march.comp.glsl", keys);
}

// They end as the picture does: a few keys of each kind of volume tell.
TEST_F(GlslValidator, TakesListsOfRays)
{
  std::vector<VariantKey> keys;
  for (const VariantKey& key : coveringKeys(legalKeys()))
  {
    if (!key.Peeled && !key.Diagnostics)
    {
      keys.push_back(key);
    }
  }
  keys.resize(std::min<std::size_t>(keys.size(), 24));
  this->expectVariants("passes/listed.frag.glsl", keys);
  this->expectVariants("passes/listed.comp.glsl", keys);
}

TEST_F(GlslValidator, TakesTheLightAtVertices)
{
  this->expectVariants("passes/vertex_light.frag.glsl", coveringKeys(legalLightKeys()));
}

TEST_F(GlslValidator, TakesTheLightAtVerticesByCompute)
{
  this->expectVariants("passes/vertex_light.comp.glsl", coveringKeys(legalLightKeys()));
}

TEST_F(GlslValidator, TakesPicks)
{
  this->expectVariants("passes/pick.frag.glsl", coveringKeys(legalPickKeys()));
}

TEST_F(GlslValidator, TakesVisits)
{
  this->expectVariants("passes/visit.frag.glsl", coveringVisitKeys());
}

TEST_F(GlslValidator, TakesThePagesOfScenes)
{
  for (const VariantKey& key : coveringKeys(legalKeys()))
  {
    this->addForPages("passes/march.frag.glsl", key, "#define TETMARCH_PACKED_SQUARES 1\n");
  }
  for (const VariantKey& key : coveringKeys(legalPickKeys()))
  {
    this->addForPages("passes/pick.frag.glsl", key);
  }
  for (const char* file : { "passes/predicate_check.frag.glsl", "passes/tile.vert.glsl",
         "passes/full_view.vert.glsl", "passes/enlarge.frag.glsl", "passes/view.frag.glsl",
         "web/background.frag.glsl", "web/surface.vert.glsl", "web/surface.frag.glsl" })
  {
    this->addForPages(file, VariantKey());
  }
  this->expectValid();
}

TEST_F(GlslValidator, TakesTheOtherPasses)
{
  for (const VariantKey& picture : coveringKeys(legalPickKeys()))
  {
    const VariantKey key = picture.ofEntries();
    if (!key.Structured) // a lattice has no such view
    {
      this->add("passes/boundary_view.frag.glsl", key.defines(), namesOf(key));
    }
  }
  const std::string driver = "#define TETMARCH_SKIPS_HELPERS 1\n";
  this->add("passes/march.frag.glsl", VariantKey().defines() + driver, "a driver that needs it");
  for (const bool fused : { false, true })
  {
    VariantKey key;
    key.EntryLists = false;
    key.HasFma = fused;
    const std::string defines = key.filtered().defines();
    this->add("passes/predicate_check.frag.glsl", defines, namesOf(key));
    this->add(
      "passes/predicate_check.frag.glsl", defines + "#define TETMARCH_HAS_PRECISE 1\n", "precise");
  }
  int others = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(TETMARCH_SHADER_DIR) / "passes"))
  {
    const std::string name = entry.path().filename().string();
    const std::set<std::string> ofVariants{ "march.frag.glsl", "vertex_light.frag.glsl",
      "listed.frag.glsl", "pick.frag.glsl", "boundary_view.frag.glsl", "visit.frag.glsl",
      "predicate_check.frag.glsl" };
    const bool entryPoint =
      name.find(".frag.") != std::string::npos || name.find(".vert.") != std::string::npos;
    if (entryPoint && ofVariants.count(name) == 0)
    {
      this->add("passes/" + name, "", "all");
      ++others;
    }
  }
  EXPECT_GT(others, 5);
  this->expectValid();
}

// A check of the check.
TEST_F(GlslValidator, RefusesWhatIsNoGlsl)
{
  std::ofstream(this->Folder / "wrong.frag")
    << "#version 450 core\nvoid main() { float x = length; }\n";
  const std::string command = "cd '" + this->Folder.string() +
                              "' && '" TETMARCH_GLSLANG_VALIDATOR "' wrong.frag > /dev/null 2>&1";
  EXPECT_NE(std::system(command.c_str()), 0);
}
} // namespace
