// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The preprocessor and ShaderConditions make the same of the one list of derived conditions.
#include "LegalKeys.h"
#include "Variants/ShaderConditions.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

namespace
{
using namespace tetmarch::testing;
using tetmarch::ShaderConditions;
using tetmarch::VariantKey;

struct Derived
{
  const char* Symbol;
  bool (VariantKey::*Answer)() const;
};

const Derived Conditions[] = {
  { "COMPOSITE", &VariantKey::isComposite },
  { "ACCUMULATES_OPACITY", &VariantKey::accumulatesOpacity },
  { "KNOWN_AT_END", &VariantKey::isKnownAtEnd },
  { "USES_TABLES", &VariantKey::usesTables },
  { "ONE_TABLE", &VariantKey::hasOneTable },
  { "OPACITY_TABLE", &VariantKey::hasOpacityTable },
  { "PASSES_CELLS", &VariantKey::passesCells },
  { "DEPENDENT", &VariantKey::isDependent },
  { "COMPONENTS", &VariantKey::hasComponents },
  { "EFFECTS", &VariantKey::hasGradients },
  { "LIT_PARTS", &VariantKey::hasLitParts },
  { "LIT", &VariantKey::isLit },
  { "SHADOWS", &VariantKey::hasShadows },
  { "VERTEX_LIGHT", &VariantKey::hasVertexLight },
  { "SAMPLED_SURFACES", &VariantKey::samplesSurfaces },
  { "ERROR_BOUND", &VariantKey::hasErrorBound },
  { "VARIATIONS", &VariantKey::needsVariations },
};

bool isTrue(ShaderConditions& conditions, const std::string& symbol)
{
  EXPECT_TRUE(conditions.take("#if TETMARCH_" + symbol + "\n"));
  EXPECT_EQ(conditions.error(), "");
  const bool active = conditions.isActive();
  EXPECT_TRUE(conditions.take("#endif\n"));
  return active;
}

// For any combination of features, whether or not the filter leaves it.
TEST(DerivedConditions, AreTheSameInGlslAndCxx)
{
  std::ifstream file(std::filesystem::path(TETMARCH_SHADER_DIR) / "derived_conditions.glsl");
  const std::string list{ std::istreambuf_iterator<char>(file), {} };
  std::mt19937 random(7);
  for (int i = 0; i < 5000; ++i)
  {
    const VariantKey key = randomKey(random);
    ShaderConditions conditions(key.defines());
    conditions.define(list);
    for (const VariantKey::Feature& feature : VariantKey::features())
    {
      ASSERT_EQ(isTrue(conditions, feature.Name), feature.isOn(key)) << feature.Name;
    }
    for (const Derived& derived : Conditions)
    {
      ASSERT_EQ(isTrue(conditions, derived.Symbol), (key.*derived.Answer)())
        << derived.Symbol << " of " << namesOf(key);
    }
  }
}
} // namespace
