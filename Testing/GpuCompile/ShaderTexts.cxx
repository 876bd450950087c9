// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The shaders for compilers of GPUs: lists variants, and writes the texts of variants that are
// asked for. A variant is a line: its pass, then the names of its features.
#include "CoreGlsl.h"
#include "CoveringKeys.h"
#include "LegalKeys.h"

#include "Variants/ShaderSource.h"

#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using namespace tetmarch::testing;
using tetmarch::VariantKey;

constexpr const char* Usage = R"(usage: tetmarch-gpu-shaders COMMAND

  list           the variants that the tests have the GL build, and the passes without variants
  legal          the lines of the standard input that are variants which a scene can make
  write FOLDER   the text of each line of the standard input: 0.frag, 1.frag and so on as GLSL 4.50,
                 and pass.vert for all of them
)";

struct Pass
{
  const char* Name;
  const char* Shader;
  std::vector<VariantKey> (*Keys)();          // null: there are no variants
  VariantKey (*Legal)(const VariantKey& key); // what the pass makes of a key
};

std::vector<VariantKey> keysOfEntries()
{
  DistinctKeys distinct;
  for (const VariantKey& picture : coveringKeys(legalPickKeys()))
  {
    if (!picture.Structured) // a lattice has no such view
    {
      distinct.add(picture.ofEntries());
    }
  }
  return distinct.Keys;
}

const std::vector<Pass> Passes = {
  { "picture", "passes/march.frag.glsl", [] { return coveringKeys(legalKeys()); },
    [](const VariantKey& key) { return key.filtered(); } },
  { "light", "passes/vertex_light.frag.glsl", [] { return coveringKeys(legalLightKeys()); },
    [](const VariantKey& key) { return key.ofVertexLight(key.Hierarchy); } },
  { "pick", "passes/pick.frag.glsl", [] { return coveringKeys(legalPickKeys()); },
    [](const VariantKey& key) { return key.ofPick(); } },
  { "boundary", "passes/boundary_view.frag.glsl", keysOfEntries,
    [](const VariantKey& key) { return key.ofEntries(); } },
  { "view", "passes/view.frag.glsl", nullptr, nullptr },
  { "selection", "passes/selection.frag.glsl", nullptr, nullptr },
  { "enlarge", "passes/enlarge.frag.glsl", nullptr, nullptr },
};

std::uint64_t bitOf(const std::string& name)
{
  for (const VariantKey::Feature& feature : VariantKey::features())
  {
    if (name == feature.Name)
    {
      return feature.Bit;
    }
  }
  throw std::runtime_error("there is no feature " + name);
}

const Pass& passOf(const std::string& name)
{
  for (const Pass& pass : Passes)
  {
    if (name == pass.Name)
    {
      return pass;
    }
  }
  throw std::runtime_error("there is no pass " + name);
}

std::string textOf(const std::string& line)
{
  std::istringstream words(line);
  std::string word;
  words >> word;
  const Pass& pass = passOf(word);
  std::uint64_t bits = 0;
  while (words >> word)
  {
    bits |= bitOf(word);
  }
  const VariantKey key = keyOf(bits);
  if (pass.Legal ? key.bits() != bits || !(pass.Legal(key) == key) : bits != 0)
  {
    throw std::runtime_error("no scene makes the variant " + line);
  }
  // As on most GPUs: see GL/Driver.h.
  const std::string gather = key.Structured ? "#define TETMARCH_HAS_GATHER 1\n" : "";
  return asCoreGlsl(tetmarch::shaderSource(pass.Shader, pass.Legal ? key.defines() + gather : ""));
}

void write(const std::string& file, const std::string& words)
{
  std::ofstream text;
  text.exceptions(std::ios::failbit | std::ios::badbit);
  text.open(file);
  text << words;
  text.close();
}

int list()
{
  for (const Pass& pass : Passes)
  {
    for (const VariantKey& key : pass.Keys ? pass.Keys() : std::vector<VariantKey>())
    {
      std::cout << pass.Name << ' ' << namesOf(key) << '\n';
    }
    std::cout << (pass.Keys ? std::string() : pass.Name + std::string("\n"));
  }
  return 0;
}

int listLegal()
{
  for (std::string line; std::getline(std::cin, line);)
  {
    try
    {
      textOf(line);
      std::cout << line << '\n';
    }
    catch (const std::runtime_error&) // of a feature that was given up, for instance
    {
    }
  }
  return 0;
}

int writeAll(const std::string& folder)
{
  int number = 0;
  for (std::string line; std::getline(std::cin, line); ++number)
  {
    write(folder + "/" + std::to_string(number) + ".frag", textOf(line));
  }
  write(folder + "/pass.vert", asCoreGlsl(tetmarch::shaderSource("passes/full_view.vert.glsl")));
  return 0;
}
} // namespace

int main(int argc, char** argv)
try
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 1 && arguments[0] == "list")
  {
    return list();
  }
  if (arguments.size() == 1 && arguments[0] == "legal")
  {
    return listLegal();
  }
  if (arguments.size() == 2 && arguments[0] == "write")
  {
    return writeAll(arguments[1]);
  }
  std::cerr << Usage;
  return 2;
}
catch (const std::exception& error)
{
  std::cerr << "tetmarch-gpu-shaders: " << error.what() << '\n';
  return 1;
}
