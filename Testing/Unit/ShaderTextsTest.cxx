// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Each text of a shader is built once.
#include "Variants/ShaderTexts.h"
#include "Variants/ShaderSource.h"
#include "Variants/VariantKey.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;

TEST(ShaderTexts, AreBuiltOnce)
{
  ShaderTexts texts;
  VariantKey key;
  const std::string defines = key.defines();
  key.Clipped = true;
  const std::string clipped = key.defines();
  const char* const file = "passes/march.frag.glsl";
  const std::string& text = texts.of(file, defines);
  EXPECT_EQ(text, shaderSource(file, defines));
  const std::string& other = texts.of(file, clipped);
  EXPECT_EQ(other, shaderSource(file, clipped));
  EXPECT_NE(text, other);
  EXPECT_EQ(&texts.of(file, defines), &text); // the same object: nothing was built
  EXPECT_EQ(&texts.of(file, clipped), &other);
}
} // namespace
