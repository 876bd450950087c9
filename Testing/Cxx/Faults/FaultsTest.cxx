// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Errors say what the GL has refused: a framebuffer, a line of a shader, a number of texels.
#include "FaultScene.h"
#include "GLObjects.h"
#include "Scene.h"

#include "vtkActor.h"

#include <cstring>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

class Faults : public FaultScene<Scene>
{
protected:
  Faults()
  {
    this->Shown.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
    this->Mapper->CollectDiagnosticsOn();
    this->lookOnce();
  }
};

TEST_F(Faults, FramebuffersSayWhich)
{
  // Without the probe, which a window meets once.
  const char* words[] = { "depths of opaque geometry", "3 float texture(s) of 64 x 64 pixels" };
  for (int call = 0; call < 2; ++call)
  {
    this->Watch.Errors.clear();
    EXPECT_TRUE(this->meet(Fault::FramebufferStatus, call));
    this->expectEmpty(this->Shown.frame());
    ASSERT_EQ(this->Watch.Errors.size(), 1u);
    EXPECT_NE(this->Watch.Errors[0].find(words[call]), std::string::npos) << this->Watch.Errors[0];
    this->expectSound(this->frame());
  }
}

// The error has the name of the file and the line in it, whatever the text of the variant adds.
TEST_F(Faults, ShaderErrorsSayWhere)
{
  const struct
  {
    const char* File;
    const char* Good;
    const char* Bad;
  } cases[] = { { "passes/march_pixel.glsl", "return castPlainRay(", "return castNothing(" },
    { "march/ray_cast.glsl", "March castPlainRay(", "March castPlainRay(NoSuchType x, " },
    { "passes/tile.vert.glsl", "gl_Position = vec4(right", "gl_NoPosition = vec4(right" } };
  for (const auto& c : cases)
  {
    int line = 0; // the same, counted by hand
    const auto spoil = [&](const std::string& text)
    {
      std::string spoilt = text;
      const std::size_t at = text.find(c.Good);
      return at == std::string::npos ? text : spoilt.replace(at, std::strlen(c.Good), c.Bad);
    };
    std::ifstream file(std::string(TETMARCH_SHADER_DIR "/") + c.File);
    std::string text;
    for (int at = 1; std::getline(file, text) && line == 0; ++at)
    {
      line = text.find(c.Good) == std::string::npos ? 0 : at;
    }
    ASSERT_GT(line, 0) << c.File;
    this->Watch.Errors.clear();
    for (int i = 0; i < 2; ++i)
    {
      this->release(true);
      EXPECT_TRUE(this->meet(spoil));
      this->expectEmpty(this->Shown.frame());
    }
    ASSERT_EQ(this->Watch.Errors.size(), 1u);
    const std::string& error = this->Watch.Errors[0];
    EXPECT_NE(error.find("could not be built"), std::string::npos) << error;
    EXPECT_NE(error.find(c.File + (":" + std::to_string(line))), std::string::npos) << error;
    this->expectSound(this->frame());
    EXPECT_EQ(this->Watch.Errors.size(), 1u);
  }
}

TEST_F(Faults, MeshesOfMoreTexelsThanTheGLTakes)
{
  const int tets = static_cast<int>(this->Mapper->GetNumberOfTetrahedra());
  const vtkTypeInt64 bytes = this->Mapper->GetUploadedBytes();
  const auto claim = [&](int texels)
  {
    this->Mapper->Around = [texels](const std::function<void()>& draw)
    {
      const FaultyGL faulty = FaultyGL::withMostTexels(texels);
      draw();
    };
  };
  const int most = tets - tets / 2;
  claim(most - 1);
  this->expectEmpty(this->frame());
  this->expectEmpty(this->frame());
  ASSERT_EQ(this->Watch.Errors.size(), 1u);
  for (const std::string& word : { "needs " + std::to_string(tets) + " texels for its tetrahedra",
         "takes " + std::to_string(2 * most - 2) + " (2 x GL_MAX" })
  {
    EXPECT_NE(this->Watch.Errors[0].find(word), std::string::npos) << this->Watch.Errors[0];
  }
  EXPECT_EQ(this->Mapper->GetGPUMemoryBytes(), 0);
  claim(tets);
  this->expectSound(this->frame());
  EXPECT_EQ(this->Mapper->GetMeshBuilds(), 1);
  EXPECT_EQ(this->Mapper->GetUploadedBytes(), 2 * bytes);
  // The types of cells alone tell how many texels are needed.
  claim(most - 1);
  const Grid stored32 = withCells32(this->Shown.Data);
  this->Mapper->SetInputData(stored32);
  this->expectEmpty(this->frame());
  ASSERT_EQ(this->Watch.Errors.size(), 2u);
  EXPECT_NE(this->Watch.Errors[1].find("at least " + std::to_string(tets)), std::string::npos);
  EXPECT_EQ(this->Mapper->GetMeshBuilds(), 1);
  this->Mapper->Around = nullptr;
  this->expectSound(this->frame());
  EXPECT_EQ(this->Mapper->GetMeshBuilds(), 2);
}
} // namespace
