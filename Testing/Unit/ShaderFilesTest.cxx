// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a driver needs is in the texts that need it; conditions are of symbols that there are.
#include "CoveringKeys.h"
#include "Variants/ShaderConditions.h"
#include "Variants/ShaderSource.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <regex>
#include <sstream>

namespace
{
using namespace tetmarch::testing;
using tetmarch::ShaderConditions;
using tetmarch::shaderSource;
using tetmarch::VariantKey;

std::size_t firstDeclaration(const std::string& text)
{
  std::istringstream lines(text);
  std::size_t at = 0;
  for (std::string line; std::getline(lines, line); at += line.size() + 1)
  {
    if (!line.empty() && line[0] != '#' && line.compare(0, 2, "//") != 0)
    {
      return at;
    }
  }
  return at;
}

// In all that march, and only where the driver needs it. Mesa accepts extensions only before
// declarations.
TEST(ShaderFiles, KeepHelpersOutOfLoops)
{
  const std::string defines = VariantKey().defines();
  for (const char* file :
    { "passes/march.frag.glsl", "passes/pick.frag.glsl", "passes/boundary_view.frag.glsl",
      "passes/vertex_light.frag.glsl", "passes/listed.frag.glsl" })
  {
    const std::string text = shaderSource(file, defines + "#define TETMARCH_SKIPS_HELPERS 1\n");
    EXPECT_NE(text.find("#define IS_HELPER gl_HelperInvocation"), std::string::npos) << file;
    EXPECT_NE(text.find("if (IS_HELPER"), std::string::npos) << file;
    EXPECT_LT(text.rfind("#extension"), firstDeclaration(text)) << file;
    EXPECT_EQ(shaderSource(file, defines).find("gl_HelperInvocation"), std::string::npos) << file;
  }
}

// Four values at once are those at the corners of a trilinear cell.
TEST(ShaderFiles, GatherWhereCellsAreTrilinear)
{
  int trilinear = 0;
  for (const VariantKey& key : coveringKeys(legalKeys()))
  {
    const char* file = "passes/march.frag.glsl";
    const std::string without = shaderSource(file, key.defines());
    const std::string with = shaderSource(file, key.defines() + "#define TETMARCH_HAS_GATHER 1\n");
    const bool gathers = key.Structured && key.PointScalars;
    const char* gather = key.Slabs ? "textureGather(slab" : "textureGather(valueTexture";
    EXPECT_EQ(without.find(gather), std::string::npos) << namesOf(key);
    EXPECT_EQ(with.find(gather) != std::string::npos, gathers) << namesOf(key);
    EXPECT_EQ(without != with, gathers) << namesOf(key);
    trilinear += gathers ? 1 : 0;
  }
  EXPECT_GT(trilinear, 20);
}

// Every symbol is one of a key, of a pass or of the list of derived conditions, also in the parts
// that a key leaves out.
TEST(ShaderFiles, HaveConditionsOfKnownSymbols)
{
  std::ifstream list(std::filesystem::path(TETMARCH_SHADER_DIR) / "derived_conditions.glsl");
  const std::string defines =
    VariantKey().defines() + std::string(std::istreambuf_iterator<char>(list), {});
  const std::regex symbol("TETMARCH_\\w+");
  int conditions = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(TETMARCH_SHADER_DIR))
  {
    if (entry.path().extension() != ".glsl")
    {
      continue;
    }
    std::ifstream file(entry.path());
    ShaderConditions known(defines);
    int number = 0;
    for (std::string line; std::getline(file, line);)
    {
      const std::string place = entry.path().filename().string() + ":" + std::to_string(++number);
      const bool condition = known.take(line + "\n");
      EXPECT_EQ(known.error(), "") << place;
      conditions += condition ? 1 : 0;
      std::smatch match;
      for (std::string rest = line; std::regex_search(rest, match, symbol); rest = match.suffix())
      {
        EXPECT_TRUE(condition) << place;
        EXPECT_NE(defines.find("#define " + match.str() + " "), std::string::npos) << place;
      }
    }
    EXPECT_TRUE(known.isClosed()) << entry.path();
  }
  EXPECT_GT(conditions, 100);
}
} // namespace
