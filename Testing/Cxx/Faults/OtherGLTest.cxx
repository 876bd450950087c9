// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A GL that answers otherwise than Mesa's llvmpipe, within what OpenGL allows or below it: the same
// picture, or one message before anything is drawn.
#include "OtherGL.h"
#include "ErrorWatch.h"
#include "FaultyGL.h"
#include "GLObjects.h"
#include "LitScene.h"

#include "vtkLogger.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

using Texts = std::vector<std::string>;

constexpr int Side = 64;

// A layer of cubes: most of its tetrahedra are at the boundary.
Grid slab(int cubes)
{
  return maskedLattice(
    cubes, 0.15, 1, sineField(), [cubes](int, int, int k) { return k == cubes / 2; });
}

class OtherGLs : public testing::Test
{
protected:
  OtherGLs()
  {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // VTK looks for errors, too
    this->Shown.Renderer->SetBackground(0.2, 0.4, 0.6);
    this->Shown.Volume->VisibilityOff();
    this->Shown.Window->Render();
    this->Empty = this->Shown.frame();
    this->Shown.Volume->VisibilityOn();
  }
  ~OtherGLs() override { vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO); }

  Image drawnAnew()
  {
    this->Shown.Mapper->ReleaseGraphicsResources(this->Shown.Window);
    this->Shown.Window->Render();
    return this->Shown.frame();
  }

  LitScene Shown{ slab(30), Side, Side };
  ErrorWatch Watch{ this->Shown.Mapper };
  Image Empty;
};

// Up to OpenGL 3.0 a buffer's texture is asked for by glGetIntegerv(), later by
// glGetTexLevelParameteriv(). A GL may know one of these alone, and have an error for the other.
TEST_F(OtherGLs, KnowTheBufferOfATextureByEitherQuery)
{
  const Image sound = this->drawnAnew();
  EXPECT_GT(compare(sound, this->Empty).Max, 0.1);
  const std::vector<GLenum> refused{ GL_TEXTURE_BUFFER_DATA_STORE_BINDING };
  for (int which = 1; which <= 3; ++which)
  {
    GLAnswers answers;
    answers.RefusedIntegers = which & 1 ? refused : std::vector<GLenum>();
    answers.RefusedLevelParameters = which & 2 ? refused : std::vector<GLenum>();
    const OtherGL other(answers);
    EXPECT_EQ(compare(this->drawnAnew(), sound).Max, 0.0) << which;
    EXPECT_EQ(this->Watch.Errors, Texts()) << which;
    EXPECT_EQ(other.refusals() > 0, which != 1) << which;
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << which;
  }
}

// Lists of entries, too, which have more candidates than there are faces.
TEST_F(OtherGLs, TakeFewTexels)
{
  constexpr std::size_t most = 4100;
  std::size_t candidates = 0; // of entries, without the limit
  for (const int side : { 16, 40, Side, 130, 200 })
  {
    this->Shown.Window->SetSize(side, side);
    Image sound;
    {
      const OtherGL same({});
      sound = this->drawnAnew();
      candidates = std::max(candidates, same.mostTexelsMade(GL_RG32UI));
    }
    GLAnswers few;
    few.Integers[GL_MAX_TEXTURE_BUFFER_SIZE] = GLint(most);
    const OtherGL other(few);
    EXPECT_EQ(compare(this->drawnAnew(), sound).Max, 0.0) << side;
    EXPECT_LE(other.mostTexelsMade(), most) << side;
    EXPECT_EQ(this->Watch.Errors, Texts()) << side;
  }
  EXPECT_GT(candidates, most) << "the limit is of no account";
}

// A march that a fault of the driver leads in circles is stopped, and a frame that counts says so.
TEST_F(OtherGLs, LeadRaysAstray)
{
  const Image sound = this->drawnAnew();
  auto* shaders = vtkOpenGLRenderWindow::SafeDownCast(this->Shown.Window)->GetShaderCache();
  shaders->ReleaseGraphicsResources(this->Shown.Window);
  for (int frame = 0; frame < 2; ++frame)
  {
    const FaultyGL circles(
      [](const std::string& text)
      {
        const std::string guard = "uniform int mostSteps;";
        const std::size_t at = text.find(guard);
        return at == std::string::npos
                 ? text
                 : std::string(text).replace(at, guard.size(), "const int mostSteps = 2;");
      });
    EXPECT_GT(compare(this->drawnAnew(), sound).Max, 0.0);
  }
  EXPECT_GT(this->Shown.Mapper->GetNumberOfGuardHits(), 100);
  EXPECT_EQ(this->Watch.Errors, Texts());
  ASSERT_EQ(this->Watch.Warnings.size(), 1u);
  EXPECT_NE(this->Watch.Warnings[0].find(
              std::to_string(this->Shown.Mapper->GetNumberOfGuardHits()) + " were stopped"),
    std::string::npos)
    << this->Watch.Warnings[0];
  shaders->ReleaseGraphicsResources(this->Shown.Window);
}

// Of what can be left out, what rays need to skip what is not seen is left out first.
TEST_F(OtherGLs, HaveFewTextureUnits)
{
  vtkNew<vtkPiecewiseFunction> little;
  little->AddPoint(0.75, 0.0);
  little->AddPoint(0.95, 0.9);
  this->Shown.property()->SetScalarOpacity(little);
  this->Shown.addGradientOpacity();
  this->Shown.Mapper->AmbientOcclusionOn();
  const Image sound = this->drawnAnew();
  GLAnswers few;
  few.Integers[GL_MAX_TEXTURE_IMAGE_UNITS] = few.Integers[GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS] = 12;
  {
    const OtherGL other(few);
    EXPECT_LE(compare(this->drawnAnew(), sound).Max, 2.001 / 255.0);
    EXPECT_EQ(this->Watch.Errors, Texts());
  }
  few.Integers[GL_MAX_TEXTURE_IMAGE_UNITS] = few.Integers[GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS] = 8;
  {
    const OtherGL fewer(few);
    EXPECT_EQ(compare(this->drawnAnew(), this->Empty).Max, 0.0);
    this->Shown.Window->Render();
  }
  ASSERT_EQ(this->Watch.Errors.size(), 1u);
  EXPECT_NE(this->Watch.Errors[0].find("the GL lets a shader read 8"), std::string::npos)
    << this->Watch.Errors[0];
  EXPECT_EQ(compare(this->drawnAnew(), sound).Max, 0.0);
}

TEST_F(OtherGLs, LackWhatIsNeeded)
{
  const Image sound = this->drawnAnew();
  struct
  {
    const char* Lacks;
    GLAnswers Answers;
  } cases[4] = { { "OpenGL 3.2 or later", {} }, { "OpenGL 3.2 or later", {} },
    { "texture buffers", {} }, { "textures of depths", {} } };
  cases[0].Answers.Strings[GL_VERSION] = "OpenGL ES 3.2 Mesa";
  cases[1].Answers.Integers = { { GL_MAJOR_VERSION, 3 }, { GL_MINOR_VERSION, 1 } };
  cases[2].Answers.Integers[GL_MAX_TEXTURE_BUFFER_SIZE] = 0;
  cases[3].Answers.HasDepthTextures = false;
  for (const auto& c : cases)
  {
    this->Watch.Errors.clear();
    {
      const OtherGL other(c.Answers);
      const auto uploaded = this->Shown.Mapper->GetUploadedBytes();
      EXPECT_EQ(compare(this->drawnAnew(), this->Empty).Max, 0.0) << c.Lacks;
      this->Shown.Window->Render();
      EXPECT_EQ(this->Shown.Mapper->GetUploadedBytes(), uploaded) << c.Lacks;
    }
    ASSERT_EQ(this->Watch.Errors.size(), 1u) << c.Lacks;
    EXPECT_NE(this->Watch.Errors[0].find(std::string("Volumes need ") + c.Lacks), std::string::npos)
      << this->Watch.Errors[0];
    EXPECT_EQ(compare(this->drawnAnew(), sound).Max, 0.0) << c.Lacks;
    EXPECT_EQ(this->Watch.Errors.size(), 1u);
  }
}
} // namespace
