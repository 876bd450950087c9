// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How many textures a shader reads at once: counted in its text, and against the units that a GL
// has at least.
#include "Variants/SamplerCount.h"

#include "CoveringKeys.h"
#include "LegalKeys.h"
#include "Variants/ShaderSource.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr int LeastUnits = 16; // OpenGL guarantees so many in one stage

int numberOf(const std::string& declared)
{
  const std::size_t bracket = declared.find('[');
  return bracket == std::string::npos ? 1 : std::stoi(declared.substr(bracket + 1));
}

int samplersIn(const std::string& text)
{
  int samplers = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::string uniform, type, name;
    words >> uniform >> type >> name;
    samplers += uniform == "uniform" && type.find("sampler") < 2 ? numberOf(name) : 0;
  }
  return samplers;
}

void expectCounted(const std::vector<VariantKey>& keys, const char* file, int beside)
{
  ASSERT_GT(keys.size(), 30u);
  for (const VariantKey& key : keys)
  {
    const int ofPeeling = key.Peeled ? SamplersOfPeeling : 0; // not in the text yet
    ASSERT_EQ(samplersIn(shaderSource(file, key.defines())) + ofPeeling, samplersOf(key) + beside)
      << file << " of " << namesOf(key);
  }
}

TEST(SamplerCount, IsThatOfTheText)
{
  std::vector<VariantKey> some = coveringKeys(legalKeys());
  expectCounted(some, "passes/march.frag.glsl", 0);
  some.erase(
    std::remove_if(some.begin(), some.end(), [](const VariantKey& key) { return key.Peeled; }),
    some.end());
  expectCounted(some, "passes/march.comp.glsl", 0);
  expectCounted(some, "passes/listed.frag.glsl", SamplersOfRayLists);
  some = coveringVisitKeys();
  some.erase(std::remove_if(some.begin(), some.end(),
               [](const VariantKey& key) { return !key.accumulatesOpacity(); }),
    some.end());
  expectCounted(some, "passes/visit.frag.glsl", SamplersOfVisits);
}

// What a scene can't do without fits, but for more tetrahedra than a buffer takes, and for passes
// that peel. Of several slabs there are but two where units are few (GL/ValueTextures).
TEST(SamplerCount, FitsWhatOpenGLGuarantees)
{
  int most = 0;
  for (const VariantKey& key : legalKeys())
  {
    const VariantKey fitted = fittedTo(LeastUnits, key);
    if (!key.Peeled && !key.SplitCells && !key.ManySlabs)
    {
      ASSERT_LE(samplersOf(fitted), LeastUnits) << namesOf(fitted);
    }
    most = std::max(most, samplersOf(key));
    ASSERT_EQ(samplersOf(fittedTo(32, key)), samplersOf(key)) << namesOf(key);
  }
  EXPECT_EQ(most, 25);
}

// Shaders that are not fitted.
TEST(SamplerCount, OfLightAndPicks)
{
  for (const VariantKey& key : coveringKeys(legalLightKeys()))
  {
    ASSERT_LE(samplersIn(shaderSource("passes/vertex_light.frag.glsl", key.defines())), LeastUnits)
      << namesOf(key);
  }
  for (const VariantKey& key : coveringKeys(legalPickKeys()))
  {
    const int samplers = samplersIn(shaderSource("passes/pick.frag.glsl", key.defines()));
    ASSERT_LE(samplers, key.SplitCells ? LeastUnits + 1 : LeastUnits) << namesOf(key);
  }
}

TEST(SamplerCount, FittedKeysGatherTheSame)
{
  int fitted = 0;
  for (const VariantKey& key : legalKeys())
  {
    VariantKey fewer = fittedTo(LeastUnits, key);
    fitted += fewer == key ? 0 : 1;
    fewer.VisiblePart = key.VisiblePart;
    fewer.Leaps = key.Leaps;
    fewer.TransparentRanges = key.TransparentRanges; // of leaps
    EXPECT_TRUE(fewer.EntryLists || fewer.Hierarchy || key.Structured) << namesOf(key);
    fewer.EntryLists = key.EntryLists;
    fewer.Reentered = key.Reentered; // of lists
    ASSERT_EQ(fewer.bits(), key.bits()) << namesOf(key);
  }
  EXPECT_GT(fitted, 1000);
}
} // namespace
