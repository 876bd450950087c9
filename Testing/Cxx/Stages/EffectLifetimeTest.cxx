// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Effects are made again after a window is closed or its resources are released, and a frame that
// was aborted while light was computed spoils no later one.
#include "ErrorWatch.h"
#include "GLObjects.h"
#include "LitScene.h"
#include "Observer.h"

#include "vtkActor.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;

constexpr int Side = 96;
constexpr double Tiny = 1e-9;

class EffectLifetime : public testing::Test
{
protected:
  EffectLifetime()
  {
    this->prepare(this->Shown);
    this->Expected = this->Shown.render();
  }

  // With all that effects keep on the GPU.
  void prepare(LitScene& scene)
  {
    scene.addGradientOpacity();
    scene.Mapper->SetShadowMethodToAtVertices();
    scene.Mapper->AmbientOcclusionOn();
    scene.Mapper->SetVolumetricScatteringBlending(0.5f);
    scene.Mapper->OpaqueShadowsOn();
    scene.Renderer->AddActor(this->Ball);
  }

  void expectSame(const Image& picture) const { EXPECT_EQ(picture.Rgba, this->Expected.Rgba); }

  vtkSmartPointer<vtkRenderWindow> makeOtherWindow()
  {
    auto window = makeWindow(Side, Side);
    vtkNew<vtkRenderer> renderer;
    renderer->SetActiveCamera(this->Shown.camera());
    renderer->AddLight(this->Shown.Sun);
    renderer->AddVolume(this->Shown.Volume);
    renderer->AddActor(this->Ball);
    window->AddRenderer(renderer);
    return window;
  }

  Image renderIn(vtkRenderWindow* window)
  {
    window->Render();
    return floatPictureOf(this->Shown.Mapper, Side, Side);
  }

  LitScene Shown{ jitteredLattice(8, 0.15, 1, sineField()), Side, Side };
  // Between the volume and the light, out of sight.
  vtkSmartPointer<vtkActor> Ball = makeBall({ 5.5, 7.5, 2.5 }, 0.3, { 1.0, 1.0, 1.0 });
  Image Expected;
};

TEST_F(EffectLifetime, ReleasedAndDrawnAgain)
{
  const vtkTypeInt64 bytes = this->Shown.Mapper->GetGPUMemoryBytes();
  const auto objects = countGLObjects();
  for (int i = 1; i <= 2; ++i)
  {
    this->Shown.Mapper->ReleaseGraphicsResources(this->Shown.Window);
    EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), 0);
    this->expectSame(this->Shown.render());
    EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), bytes);
    EXPECT_EQ(countGLObjects(), objects);
    // On the GPU only.
    EXPECT_EQ(this->Shown.Mapper->GetVertexLightBuilds(), 1 + i);
    EXPECT_EQ(this->Shown.Mapper->GetGradientsBuilds(), 1);
    EXPECT_EQ(this->Shown.Mapper->GetOpaqueShadowsBuilds(), 1);
  }
}

TEST_F(EffectLifetime, WindowFinalizedAndDrawnAgain)
{
  this->Shown.Window->Finalize();
  this->expectSame(this->Shown.render());
  this->expectSame(this->Shown.render());
}

TEST_F(EffectLifetime, TwoWindowsByTurns)
{
  const auto second = this->makeOtherWindow();
  for (int i = 0; i < 2; ++i)
  {
    this->expectSame(this->renderIn(second));
    this->expectSame(this->Shown.render());
  }
}

TEST_F(EffectLifetime, SecondWindowAfterTheFirstIsDeleted)
{
  const auto second = this->makeOtherWindow();
  this->Shown.Window = nullptr;
  this->expectSame(this->renderIn(second));
}

// Each of two mappers has effects of its own.
TEST_F(EffectLifetime, TwoMappersInAWindow)
{
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.0, 0.0, 0.5, 0.5);
  this->Shown.Renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  const Image expected = this->Shown.render();
  vtkNew<vtkVolume> volume;
  vtkNew<Mapper> mapper;
  const Grid grid = jitteredLattice(5, 0.15, 2, sineField());
  mapper->SetInputData(grid);
  mapper->SetShadowMethodToAtVertices();
  volume->SetMapper(mapper);
  volume->SetProperty(this->Shown.property());
  other->AddVolume(volume);
  other->AddLight(this->Shown.Sun);
  this->Shown.Window->AddRenderer(other);
  EXPECT_EQ(this->Shown.render().Rgba, expected.Rgba);
  other->RemoveVolume(volume);
  EXPECT_EQ(this->Shown.render().Rgba, expected.Rgba);
}

// Without diagnostics: a window compiles these variants for long.
TEST(EffectLifetimeAlongRays, ReleasedAndDrawnAgain)
{
  LitScene scene(jitteredLattice(8, 0.15, 1, sineField()), Side, Side);
  scene.Mapper->CollectDiagnosticsOff();
  scene.Mapper->SetShadowMethodToAlongRays();
  scene.Window->Render();
  const Image expected = scene.frame();
  const vtkTypeInt64 bytes = scene.Mapper->GetGPUMemoryBytes();
  const auto objects = countGLObjects();
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), 0);
  scene.Window->Render();
  EXPECT_EQ(scene.frame().Rgba, expected.Rgba);
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), bytes);
  EXPECT_EQ(countGLObjects(), objects);
  EXPECT_EQ(scene.Mapper->GetVertexLightBuilds(), 0);
}

class AbortedLight : public testing::Test
{
protected:
  AbortedLight()
  {
    this->prepare(this->Shown);
    this->Shown.Volume->VisibilityOff();
    this->Shown.Window->Render();
    this->Empty = this->Shown.frame();
    this->Shown.Volume->VisibilityOn();
    this->Shown.Mapper->SetMaxDrawTimeInSeconds(Tiny);
  }

  void prepare(LitScene& scene)
  {
    scene.Renderer->SetBackground(0.2, 0.4, 0.6);
    scene.Mapper->SetShadowMethodToAtVertices();
  }

  // The picture without a limit of time.
  Image expected()
  {
    LitScene scene(this->Shown.Data, Side, Side);
    this->prepare(scene);
    scene.Sun->SetPosition(this->Shown.Sun->GetPosition());
    return scene.render();
  }

  // Rendering ends behind the first tile of the light, with nothing drawn.
  void abort()
  {
    const vtkTypeInt64 builds = this->Shown.Mapper->GetVertexLightBuilds();
    const Observer observer(this->Shown.Mapper, vtkCommand::ProgressEvent,
      [this]
      {
        Mapper* mapper = this->Shown.Mapper;
        this->Shown.Window->SetAbortRender(
          mapper->GetMeshBuilds() > 0 && mapper->GetProgress() < 1.0);
      });
    this->Shown.Window->Render();
    EXPECT_EQ(this->Shown.Mapper->GetNumberOfDraws(), 0);
    EXPECT_EQ(this->Shown.Mapper->GetNumberOfRays(), 0);
    EXPECT_EQ(this->Shown.Mapper->GetVertexLightBuilds(), builds);
    EXPECT_EQ(compare(this->Shown.frame(), this->Empty).Max, 0.0);
  }

  void expectRight()
  {
    const vtkTypeInt64 builds = this->Shown.Mapper->GetVertexLightBuilds();
    EXPECT_EQ(this->Shown.render().Rgba, this->expected().Rgba);
    EXPECT_GT(this->Shown.Mapper->GetNumberOfDraws(), 1);
    EXPECT_EQ(this->Shown.Mapper->GetVertexLightBuilds(), builds + 1);
    EXPECT_EQ(this->Watch.Errors, std::vector<std::string>());
  }

  LitScene Shown{ jitteredLattice(16, 0.15, 1, sineField()), Side, Side };
  ErrorWatch Watch{ this->Shown.Mapper };
  Image Empty;
};

TEST_F(AbortedLight, OfTheFirstFrame)
{
  this->abort();
  this->abort();
  this->expectRight();
}

TEST_F(AbortedLight, OfALightThatMoves)
{
  this->expectRight();
  this->Shown.Sun->SetPosition(-3.0, 4.0, 1.5);
  this->abort();
  this->expectRight();
}

// Of what was there before, part is gone.
TEST_F(AbortedLight, OfALightThatMovesBack)
{
  this->expectRight();
  this->Shown.Sun->SetPosition(-3.0, 4.0, 1.5);
  this->abort();
  this->Shown.Sun->SetPosition(3.0, 4.0, 1.5);
  this->expectRight();
}

TEST_F(AbortedLight, ByReleasingIt)
{
  this->expectRight();
  this->Shown.Sun->SetPosition(-3.0, 4.0, 1.5);
  {
    const Observer observer(this->Shown.Mapper, vtkCommand::ProgressEvent,
      [this] { this->Shown.Mapper->ReleaseGraphicsResources(this->Shown.Window); });
    this->Shown.Window->Render();
    EXPECT_EQ(this->Shown.Mapper->GetNumberOfDraws(), 0);
    EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), 0);
  }
  this->expectRight();
}
} // namespace
