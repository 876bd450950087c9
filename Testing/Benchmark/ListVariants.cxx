// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Prints the variants whose scenes compare_pictures.py draws: a line each, "picture" or "pick" and
// the names of its features but HAS_FMA. With a folder, the shader texts of these variants are
// written into it: 0-portable.frag of the first line, 0-fma.frag with HAS_FMA.
#include "CoveringKeys.h"
#include "LegalKeys.h"

#include "Variants/ShaderSource.h"

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

/// Surfaces that cast shadows are seen as well, and whether there is fma is the driver's choice.
std::vector<VariantKey> withScenes(const std::vector<VariantKey>& keys)
{
  DistinctKeys distinct;
  for (VariantKey key : keys)
  {
    key.OpaqueDepth = key.OpaqueDepth || key.OpaqueShadows;
    key.HasFma = false;
    distinct.add(key.filtered());
  }
  return distinct.Keys;
}

/// Returns whether the file could be written.
bool writeText(const std::string& file, const char* shader, VariantKey key, bool fma)
{
  key.HasFma = fma;
  std::ofstream text(file);
  text << tetmarch::shaderSource(shader, key.defines());
  text.close();
  return text.good();
}
} // namespace

int main(int count, char** arguments)
{
  if (count > 2)
  {
    std::cerr << "Usage: tetmarch-variants [FOLDER]\n";
    return 2;
  }
  const std::vector<Pass> passes = {
    { "picture", "passes/march.frag.glsl", withScenes(coveringKeys(legalKeys())) },
    { "pick", "passes/pick.frag.glsl", withScenes(coveringKeys(legalPickKeys())) },
  };
  int line = 0;
  for (const Pass& pass : passes)
  {
    for (const VariantKey& key : pass.Keys)
    {
      std::cout << pass.Name << " " << namesOf(key) << "\n";
      for (const bool fma : { false, true })
      {
        if (count == 2)
        {
          const std::string file = std::string(arguments[1]) + "/" + std::to_string(line) +
                                   (fma ? "-fma.frag" : "-portable.frag");
          if (!writeText(file, pass.Shader, key, fma))
          {
            std::cerr << "tetmarch-variants: " << file << " can't be written\n";
            return 1;
          }
        }
      }
      ++line;
    }
  }
  return 0;
}
