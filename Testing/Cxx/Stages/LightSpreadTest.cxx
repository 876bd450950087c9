// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// While a user interacts light at vertices is made over several frames, and at rest it is what it
// would have been at once.
#include "ErrorWatch.h"
#include "GLObjects.h"
#include "LitScene.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;

constexpr int Side = 96;
constexpr double Tiny = 1e-9;
constexpr double Interactive = 15.0; // updates a second
constexpr double Still = 0.0001;
constexpr int Frames = 10; // 17^3 vertices, 512 a frame

class LightSpread : public testing::Test
{
protected:
  LightSpread()
  {
    this->mapper()->SetShadowMethodToAtVertices();
    this->mapper()->SetLightTimeBudget(Tiny);
    this->mapper()->AutoAdjustSampleDistancesOff();
    this->Shown.Window->SetDesiredUpdateRate(Interactive);
  }

  Mapper* mapper() { return this->Shown.Mapper; }

  Image frame()
  {
    this->Shown.Window->Render();
    return this->Shown.frame();
  }

  // The scene as it is now by a mapper that makes light at once.
  Image expected()
  {
    LitScene scene(this->Shown.Data, Side, Side);
    scene.Mapper->SetShadowMethod(this->mapper()->GetShadowMethod());
    scene.Mapper->SetAmbientOcclusion(this->mapper()->GetAmbientOcclusion());
    scene.Sun->SetPosition(this->Shown.Sun->GetPosition());
    scene.Window->Render();
    EXPECT_TRUE(scene.Mapper->IsLightComplete());
    return scene.frame();
  }

  // Renders until light is complete, in so many frames.
  void expectComplete(int frames)
  {
    const vtkTypeInt64 builds = this->mapper()->GetVertexLightBuilds();
    for (int i = 1; i < frames; ++i)
    {
      this->Shown.Window->Render();
      ASSERT_FALSE(this->mapper()->IsLightComplete()) << i;
      ASSERT_EQ(this->mapper()->GetVertexLightBuilds(), builds);
    }
    EXPECT_EQ(this->frame().Rgba, this->expected().Rgba);
    EXPECT_TRUE(this->mapper()->IsLightComplete());
    EXPECT_EQ(this->mapper()->GetVertexLightBuilds(), builds + 1);
    EXPECT_EQ(this->Watch.Errors, std::vector<std::string>());
  }

  LitScene Shown{ jitteredLattice(16, 0.15, 1, sineField()), Side, Side };
  ErrorWatch Watch{ this->Shown.Mapper };
};

TEST_F(LightSpread, NothingIsKeptOffBeforeThereIsLight)
{
  const Image first = this->frame();
  EXPECT_FALSE(this->mapper()->IsLightComplete());
  this->mapper()->SetShadowMethodToOff();
  EXPECT_LT(compare(first, this->frame()).Max, 1e-6);
  EXPECT_TRUE(this->mapper()->IsLightComplete());
}

TEST_F(LightSpread, ConvergesWhileInteracting)
{
  this->expectComplete(Frames);
  const vtkTypeInt64 builds = this->mapper()->GetVertexLightBuilds();
  this->Shown.camera()->Azimuth(5.0);
  this->Shown.Window->Render();
  EXPECT_TRUE(this->mapper()->IsLightComplete());
  EXPECT_EQ(this->mapper()->GetVertexLightBuilds(), builds);
}

TEST_F(LightSpread, LightOfBeforeIsShownUntilThen)
{
  this->expectComplete(Frames);
  const Image before = this->frame();
  // So little that surfaces hardly tell; shadows would be others.
  this->Shown.property()->SetScalarOpacityUnitDistance(0.3);
  this->mapper()->SetLightTimeBudget(0.0);
  const Image after = this->frame();
  EXPECT_TRUE(this->mapper()->IsLightComplete());
  this->mapper()->SetLightTimeBudget(Tiny);
  this->Shown.Sun->SetPosition(-3.0, 4.0, 1.5);
  const Image moved = this->frame();
  EXPECT_FALSE(this->mapper()->IsLightComplete());
  EXPECT_GT(compare(moved, after).Rms, 0.0);
  this->Shown.Sun->SetPosition(3.0, 4.0, 1.5);
  // The light that was being computed is given up.
  EXPECT_EQ(this->frame().Rgba, after.Rgba);
  EXPECT_TRUE(this->mapper()->IsLightComplete());
  EXPECT_NE(after.Rgba, before.Rgba);
}

TEST_F(LightSpread, BeginsAnewWhenTheSunMovesOn)
{
  this->expectComplete(Frames);
  for (int i = 1; i <= 4; ++i)
  {
    this->Shown.Sun->SetPosition(3.0 - i, 4.0, 1.5);
    this->Shown.Window->Render();
    this->Shown.Window->Render();
    EXPECT_FALSE(this->mapper()->IsLightComplete());
  }
  this->expectComplete(Frames - 2);
}

TEST_F(LightSpread, IsCompleteAtRest)
{
  this->Shown.Window->Render();
  this->Shown.Window->Render();
  this->Shown.Window->SetDesiredUpdateRate(Still);
  this->expectComplete(1);
  this->Shown.Window->SetDesiredUpdateRate(Interactive);
  this->mapper()->AmbientOcclusionOn();
  this->expectComplete(Frames);
}

TEST_F(LightSpread, IsMadeAtOnceWithoutABudget)
{
  this->mapper()->SetLightTimeBudget(0.0);
  this->expectComplete(1);
}

TEST_F(LightSpread, HoldsTwiceTheLightOnlyMeanwhile)
{
  this->expectComplete(Frames);
  const vtkTypeInt64 bytes = this->mapper()->GetGPUMemoryBytes();
  const auto objects = countGLObjects();
  this->Shown.Sun->SetPosition(-3.0, 4.0, 1.5);
  this->Shown.Window->Render();
  EXPECT_GT(this->mapper()->GetGPUMemoryBytes(), bytes);
  this->expectComplete(Frames - 1);
  EXPECT_EQ(this->mapper()->GetGPUMemoryBytes(), bytes);
  EXPECT_EQ(countGLObjects(), objects);
  // Left half made.
  this->Shown.Sun->SetPosition(0.0, 4.0, 1.5);
  this->Shown.Window->Render();
  this->Shown.Sun->SetPosition(-3.0, 4.0, 1.5);
  this->Shown.Window->Render();
  EXPECT_EQ(this->mapper()->GetGPUMemoryBytes(), bytes);
  this->Shown.Sun->SetPosition(0.0, 4.0, 1.5);
  this->Shown.Window->Render();
  this->mapper()->ReleaseGraphicsResources(this->Shown.Window);
  EXPECT_EQ(this->mapper()->GetGPUMemoryBytes(), 0);
  this->expectComplete(Frames);
}

// The light of one mesh is not shown on another one: the first frame has no shadows.
TEST_F(LightSpread, AnotherMeshBeginsWithoutShadows)
{
  this->expectComplete(Frames);
  this->Shown.Data = jitteredLattice(12, 0.15, 2, sineField());
  this->mapper()->SetInputData(this->Shown.Data);
  const Image first = this->frame();
  EXPECT_FALSE(this->mapper()->IsLightComplete());
  this->mapper()->SetShadowMethodToOff();
  EXPECT_LT(compare(first, this->frame()).Max, 1e-6);
  this->mapper()->SetShadowMethodToAtVertices();
  this->expectComplete(5); // 13^3 vertices
}
} // namespace
