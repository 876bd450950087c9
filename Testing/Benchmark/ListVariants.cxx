// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Prints the variants whose scenes compare_pictures.py draws: a line each, "picture" or "pick" and
// the names of its features but HAS_FMA. With a folder, the shader texts of these variants are
// written into it: 0-portable.frag of the first line, and 0-extended.frag with what only some
// drivers have: fused multiply-add for meshes, gathers for lattices. `precise` is in both, as most
// drivers have it, llvmpipe among them. "newer" are those of a Mesa that says which pixels help.
#include "CoveringKeys.h"
#include "LegalKeys.h"

#include "Variants/ShaderSource.h"

#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace tetmarch::testing;
using tetmarch::VariantKey;

struct Pass
{
  const char* Name;
  const char* Shader;
  std::vector<VariantKey> Keys;
};

/// The variants that scenes can ask for: surfaces that cast shadows are seen as well, a tolerance
/// samples shadows along rays, a mesh that rays of pixels enter again those towards the light do,
/// too, whether there is fma is the driver's choice, and a mesh that takes two buffers is too
/// large.
std::vector<VariantKey> ofScenes(const std::vector<VariantKey>& keys)
{
  DistinctKeys distinct;
  for (VariantKey key : keys)
  {
    key.OpaqueDepth = key.OpaqueDepth || key.OpaqueShadows;
    key.SampledShadows = key.SampledShadows || (key.LightTolerance && key.CastShadows);
    key.Reentered = key.Reentered || key.Hierarchy;
    key.Hierarchy = key.Hierarchy || (key.Reentered && !key.VisiblePart);
    key.HasFma = false;
    key.SplitCells = false;
    distinct.add(key.filtered());
  }
  return distinct.Keys;
}

void writeText(const std::string& file, const Pass& pass, const std::string& defines)
{
  std::ofstream text;
  text.exceptions(std::ios::failbit | std::ios::badbit);
  text.open(file);
  text << tetmarch::shaderSource(pass.Shader, defines);
  text.close();
}

void writeTexts(const std::string& begin, const Pass& pass, VariantKey key)
{
  // The comparison runs on llvmpipe.
  const std::string both = "#define TETMARCH_LIMITS_TURNS 1\n#define TETMARCH_HAS_PRECISE 1\n";
  const std::string newer = both + "#define TETMARCH_SKIPS_HELPERS 1\n";
  writeText(begin + "-portable.frag", pass, key.defines() + both);
  writeText(begin + "-portable-newer.frag", pass, key.defines() + newer);
  key.HasFma = !key.Structured;
  const std::string gather = key.Structured ? "#define TETMARCH_HAS_GATHER 1\n" : "";
  writeText(begin + "-extended.frag", pass, key.defines() + both + gather);
  writeText(begin + "-extended-newer.frag", pass, key.defines() + newer + gather);
}
} // namespace

int main(int count, char** arguments)
try
{
  if (count > 2)
  {
    std::cerr << "Usage: tetmarch-variants [FOLDER]\n";
    return 2;
  }
  const std::vector<Pass> passes = {
    { "picture", "passes/march.frag.glsl", ofScenes(coveringKeys(legalKeys())) },
    { "pick", "passes/pick.frag.glsl", ofScenes(coveringKeys(legalPickKeys())) },
  };
  int line = 0;
  for (const Pass& pass : passes)
  {
    for (const VariantKey& key : pass.Keys)
    {
      std::cout << pass.Name << " " << namesOf(key) << "\n";
      if (count == 2)
      {
        writeTexts(std::string(arguments[1]) + "/" + std::to_string(line), pass, key);
      }
      ++line;
    }
  }
  return 0;
}
catch (const std::exception& error)
{
  std::cerr << "tetmarch-variants: the texts can't be written: " << error.what() << "\n";
  return 1;
}
