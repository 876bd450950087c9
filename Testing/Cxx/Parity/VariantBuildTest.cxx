// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The GL builds variants with any two features together or apart, of meshes and of lattices; or, if
// TETMARCH_ALL_VARIANTS is set, all that the test of texts goes through. They are built as they are
// drawn, with what the driver defines, and those of lattices without that as well.
#include "CoveringKeys.h"
#include "LegalKeys.h"
#include "Scene.h"

#include "GL/Driver.h"
#include "Variants/ShaderSource.h"

#include "vtkLogger.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <gtest/gtest.h>
#include <iostream>
#include <map>

namespace
{
using namespace tetmarch::testing;
using tetmarch::shaderSource;
using tetmarch::VariantKey;
using tetmarch::withFileNames;

using Keys = std::vector<VariantKey>;

vtkSmartPointer<vtkShader> makeShader(vtkShader::Type type, const std::string& text)
{
  auto shader = vtkSmartPointer<vtkShader>::New();
  shader->SetType(type);
  shader->SetSource(text);
  return shader;
}

// What the GL says of a shader that it has compiled. ParaView 6.1 tells its user each warning.
std::string warningsOf(vtkShader* shader)
{
  std::string log(1000, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader->GetHandle(), static_cast<GLsizei>(log.size()), &length, &log[0]);
  log.resize(static_cast<std::size_t>(std::max(0, length)));
  return log;
}

class VariantBuild : public testing::Test
{
protected:
  VariantBuild()
  {
    this->Window->Render(); // makes the context
    this->Window->MakeCurrent();
    this->DriverDefines = tetmarch::driverDefines();
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // VTK would print the whole text
  }
  ~VariantBuild() override { vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO); }

  // The GL's error about the variant or its warnings, or nothing. It is built as VTK does, but not
  // kept.
  std::string build(const char* file, const std::string& defines)
  {
    std::map<vtkShader::Type, vtkShader*> shaders;
    std::vector<vtkSmartPointer<vtkShader>> owned;
    for (int type = vtkShader::Vertex; type < vtkShader::Unknown; ++type)
    {
      const char* name = type == vtkShader::Vertex     ? "passes/tile.vert.glsl"
                         : type == vtkShader::Fragment ? file
                                                       : nullptr;
      owned.push_back(makeShader(
        static_cast<vtkShader::Type>(type), name ? shaderSource(name, defines) : std::string()));
      shaders[static_cast<vtkShader::Type>(type)] = owned.back();
    }
    vtkNew<vtkOpenGLShaderCache> cache;
    const bool built = cache->ReadyShaderProgram(shaders) != nullptr;
    std::string message;
    for (const vtkShader::Type type : { vtkShader::Vertex, vtkShader::Fragment })
    {
      message += built ? warningsOf(shaders[type]) : shaders[type]->GetError() + "\n";
    }
    cache->ReleaseGraphicsResources(this->Window);
    return built ? withFileNames(message) : "not built: " + withFileNames(message);
  }

  void expectBuilt(const char* file, const Keys& keys, std::size_t of)
  {
    const auto begin = std::chrono::steady_clock::now();
    int failures = 0;
    std::size_t lattices = 0;
    for (const VariantKey& key : keys)
    {
      std::string error = this->build(file, key.defines() + this->DriverDefines);
      if (key.Structured && error.empty())
      {
        error = this->build(file, key.defines());
      }
      EXPECT_EQ(error, "") << file << " of " << namesOf(key);
      failures += error.empty() ? 0 : 1;
      lattices += key.Structured ? 1 : 0;
      ASSERT_LT(failures, 5) << "and so on";
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    EXPECT_GT(lattices, keys.size() / 10);
    EXPECT_LT(lattices, keys.size());
    std::cout << "[ MEASURED ] " << file << ": " << keys.size() << " of " << of << " variants, "
              << lattices << " of them of lattices, in " << seconds.count() << " s\n";
  }

  vtkSmartPointer<vtkRenderWindow> Window = makeWindow(8, 8);
  std::string DriverDefines;
};

TEST_F(VariantBuild, OfThePicture)
{
  const Keys legal = legalKeys();
  const bool all = std::getenv("TETMARCH_ALL_VARIANTS") != nullptr;
  this->expectBuilt(
    "passes/march.frag.glsl", all ? legal : coveringKeys<Twos>(legal), legal.size());
}

TEST_F(VariantBuild, OfTheLightAtVertices)
{
  const Keys legal = legalLightKeys();
  this->expectBuilt("passes/vertex_light.frag.glsl", coveringKeys<Twos>(legal), legal.size());
}

TEST_F(VariantBuild, OfWhatIsPicked)
{
  const Keys legal = legalPickKeys();
  this->expectBuilt("passes/pick.frag.glsl", coveringKeys<Twos>(legal), legal.size());
}

template <typename Settings>
void expectCovered(const Keys& legal)
{
  const auto settingsOf = [](const Keys& keys)
  {
    Settings found;
    for (const VariantKey& key : keys)
    {
      found.add(key);
    }
    return found;
  };
  const Keys few = coveringKeys<Settings>(legal);
  EXPECT_TRUE(settingsOf(few) == settingsOf(legal));
  EXPECT_FALSE(settingsOf(Keys(few.begin(), few.end() - 1)) == settingsOf(legal));
}

TEST(CoveringKeys, HaveWhatAFewBitsCanBe)
{
  const Keys legal = legalKeys();
  expectCovered<Twos>(legal);
  expectCovered<Threes>(legal);
}
} // namespace
