// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The variants of the shader for GPUs that fuse multiply and add, on whatever runs the tests.
// Mesa's software renderer does not fuse, so it never gets them otherwise. Where no three points of
// a mesh are in line with the eye, a product that is rounded twice does no harm.
#include "CpuReference.h"
#include "GLPointers.h"

#include <gtest/gtest.h>
#include <string>

namespace
{
using namespace tetmarch::testing;

// As long as it lives, the mapper finds that the GPU's fma rounds once.
class FusedShaders
{
public:
  FusedShaders()
  {
    Compiled = 0;
    Original = TETMARCH_GL_POINTER(ShaderSource);
    TETMARCH_GL_POINTER(ShaderSource) = &FusedShaders::replaced;
  }
  ~FusedShaders() { TETMARCH_GL_POINTER(ShaderSource) = Original; }
  FusedShaders(const FusedShaders&) = delete;
  FusedShaders& operator=(const FusedShaders&) = delete;

  static inline int Compiled = 0; // fused variants

private:
  static void GLAPIENTRY replaced(
    GLuint shader, GLsizei count, const GLchar* const* texts, const GLint* lengths)
  {
    std::string text;
    for (GLsizei i = 0; i < count; ++i)
    {
      text += lengths && lengths[i] >= 0 ? std::string(texts[i], lengths[i]) : texts[i];
    }
    // What passes/fma_probe.frag.glsl asks the GL, and what one that fuses would answer.
    const std::string question = "fma(onePlus, onePlus, -square)";
    const std::size_t at = text.find(question);
    if (at != std::string::npos)
    {
      text.replace(at, question.size(), "5.9604644775390625e-8");
    }
    Compiled += text.find("fma(p.x, q.y, -w)") != std::string::npos ? 1 : 0;
    const char* whole = text.c_str();
    Original(shader, 1, &whole, nullptr);
  }

  static inline PFNGLSHADERSOURCEPROC Original = nullptr;
};

void expectFusedParity(Scene& scene)
{
  scene.Window->MakeCurrent();
  const FusedShaders fused;
  expectParity(scene);
  EXPECT_GT(FusedShaders::Compiled, 0);
}

TEST(FusedVariant, PointScalars)
{
  Scene scene(jitteredLattice(8, 0.15, 1, sineField()));
  expectFusedParity(scene);
}

TEST(FusedVariant, CellScalarsOfANonConvexMesh)
{
  Scene scene(latticeWithHole(9, 0.15, 1, sineField()));
  scene.drawCellScalars();
  expectFusedParity(scene);
}

TEST(FusedVariant, SearchedEntries)
{
  Scene scene(nestedShells(10, 4, 0.15, 1, sineField()));
  scene.camera()->SetClippingRange(2.8, 3.2);
  expectFusedParity(scene);
}
} // namespace
