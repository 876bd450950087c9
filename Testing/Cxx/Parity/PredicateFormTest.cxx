// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which form of the predicate a GL gets: by multiply-add where that rounds once, in whole numbers
// where it does not or where a compiler optimises one place as another, and none if both are wrong.
// The texts of shaders are changed so that the GL at hand is each of these.
#include "CpuReference.h"
#include "ErrorWatch.h"
#include "FaultyGL.h"

#include <gtest/gtest.h>
#include <string>

namespace
{
using namespace tetmarch::testing;

bool has(const std::string& text, const char* words)
{
  return text.find(words) != std::string::npos;
}

void replace(std::string& text, const std::string& words, const std::string& by)
{
  const std::size_t at = text.find(words);
  if (at != std::string::npos)
  {
    text.replace(at, words.size(), by);
  }
}

// In double precision products of floats are exact, so that sums of them are rounded once.
std::string roundingOnce(std::string text)
{
  const std::string extension = "#extension GL_ARB_gpu_shader5 : require\n";
  if (has(text, "fma("))
  {
    replace(text, extension,
      extension + "#extension GL_ARB_gpu_shader_fp64 : require\n"
                  "#define fma(a, b, c) float(double(a) * double(b) + double(c))\n");
  }
  return text;
}

bool isCheck(const std::string& text) { return has(text, "caseTexture"); }

// Another compiler's rounding of the projection in the loop of the check.
std::string roundingOtherwiseInLoops(std::string text)
{
  if (isCheck(text))
  {
    replace(text, "pointAmong = project(ray, caseTexel(there, 1).xyz);",
      "pointAmong = project(ray, caseTexel(there, 1).xyz * 1.00000012);");
  }
  return text;
}

struct Forms
{
  int Fused = 0; // marches built
  int Whole = 0;

  std::string count(const std::string& text)
  {
    this->Fused += !isCheck(text) && has(text, "fma(p.x, q.y, -w)") ? 1 : 0;
    this->Whole += !isCheck(text) && has(text, "int wrapped") ? 1 : 0;
    return text;
  }
};

void expectFusedParity(Scene& scene)
{
  scene.Window->MakeCurrent();
  Forms forms;
  const FaultyGL gl([&](const std::string& text) { return roundingOnce(forms.count(text)); });
  expectParity(scene);
  EXPECT_GT(forms.Fused, 0);
  EXPECT_EQ(forms.Whole, 0);
}

TEST(PredicateForm, FusedWithPointScalars)
{
  Scene scene(jitteredLattice(8, 0.15, 1, sineField()));
  expectFusedParity(scene);
}

TEST(PredicateForm, FusedWithCellScalarsOfANonConvexMesh)
{
  Scene scene(latticeWithHole(9, 0.15, 1, sineField()));
  scene.drawCellScalars();
  expectFusedParity(scene);
}

TEST(PredicateForm, FusedWithSearchedEntries)
{
  Scene scene(nestedShells(10, 4, 0.15, 1, sineField()));
  scene.camera()->SetClippingRange(2.8, 3.2);
  expectFusedParity(scene);
}

TEST(PredicateForm, WholeNumbersWhereFusedOnesRoundOtherwiseInLoops)
{
  Scene scene(jitteredLattice(8, 0.15, 1, sineField()));
  scene.Window->MakeCurrent();
  Forms forms;
  const FaultyGL gl(
    [&](const std::string& text)
    {
      const std::string once = roundingOnce(forms.count(text));
      return has(text, "fma(") ? roundingOtherwiseInLoops(once) : once;
    });
  expectParity(scene);
  EXPECT_EQ(forms.Fused, 0);
  EXPECT_GT(forms.Whole, 0);
}

TEST(PredicateForm, NoneIsOneErrorInsteadOfAPicture)
{
  Scene scene(jitteredLattice(8, 0.15, 1, sineField()));
  scene.Volume->VisibilityOff();
  scene.Window->Render();
  const Image empty = framePictureOf(scene.Window);
  scene.Volume->VisibilityOn();
  Forms forms;
  const ErrorWatch watch(scene.Mapper);
  {
    const FaultyGL gl([&](const std::string& text)
      { return roundingOtherwiseInLoops(roundingOnce(forms.count(text))); });
    for (int frame = 0; frame < 3; ++frame)
    {
      scene.Window->Render();
      EXPECT_EQ(compare(framePictureOf(scene.Window), empty).Max, 0.0);
    }
  }
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_TRUE(has(watch.Errors[0], "round where they must not")) << watch.Errors[0];
  EXPECT_TRUE(has(watch.Errors[0], "Update the graphics driver")) << watch.Errors[0];
  EXPECT_EQ(forms.Fused + forms.Whole, 0);
}
} // namespace
