// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays marched by a compute shader draw what fragments draw, to the last bit.
// Testing/Benchmark/compare_pictures.py compares all variants so.
#include "BlendScene.h"
#include "CutScene.h"
#include "Variants/ShaderStage.h"

#include "vtkActor.h"
#include "vtkOpenGLRenderUtilities.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 100; // not a multiple of a group's side

Grid lattice() { return latticeWithHole(7, 0.15, 1, sineField()); }

bool hasCompute(Scene& scene)
{
  scene.Window->Render();
  int major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  return 10 * major + minor >= 43;
}

void expectEqual(const Image& a, const Image& b)
{
  EXPECT_TRUE(a.Rgba == b.Rgba) << compare(a, b, {}, 0.0, Channels::Rgb).text();
}

// The pictures in float, those of the window and what was counted.
void expectSameByCompute(Scene& scene)
{
  const auto drawn = [&](int stage)
  {
    scene.Mapper->SetShaderStage(stage);
    scene.Mapper->CollectDiagnosticsOff();
    scene.Window->Render();
    EXPECT_EQ(scene.Mapper->GetUsedShaderStage(), stage);
    return scene.frame();
  };
  const Image frame = drawn(Mapper::FRAGMENT_STAGE);
  expectEqual(frame, drawn(Mapper::COMPUTE_STAGE));
  const auto counted = [&](int stage)
  {
    scene.Mapper->SetShaderStage(stage);
    scene.Mapper->CollectDiagnosticsOn();
    return scene.render();
  };
  const Image floats = counted(Mapper::FRAGMENT_STAGE);
  const vtkTypeInt64 cells = scene.Mapper->GetNumberOfCrossedCells();
  const vtkTypeInt64 lookups = scene.Mapper->GetNumberOfLookups();
  expectEqual(floats, counted(Mapper::COMPUTE_STAGE));
  EXPECT_GT(cells, 0);
  EXPECT_EQ(scene.Mapper->GetNumberOfCrossedCells(), cells);
  EXPECT_EQ(scene.Mapper->GetNumberOfLookups(), lookups);
  expectEqual(frame, drawn(Mapper::FRAGMENT_STAGE));
  scene.Mapper->SetShaderStageToAutomatic();
}

class Compute : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!hasCompute(this->Shown))
    {
      GTEST_SKIP() << "this GL has no compute shaders";
    }
    this->Shown.Renderer->SetBackground(0.2, 0.4, 0.6);
  }

  BlendScene Shown{ lattice(), Side, Side };
};

TEST_F(Compute, InEachBlendMode)
{
  for (const int mode : BlendModes)
  {
    SCOPED_TRACE(mode);
    this->Shown.Mapper->SetBlendMode(mode);
    expectSameByCompute(this->Shown);
  }
}

TEST_F(Compute, WithLightAndShadows)
{
  expectSameByCompute(this->Shown);
  this->Shown.Mapper->SetShadowMethodToAtVertices();
  expectSameByCompute(this->Shown);
  this->Shown.Mapper->SetShadowMethodToAlongRays();
  expectSameByCompute(this->Shown);
}

TEST_F(Compute, WithCutsCellScalarsAndOpaqueGeometry)
{
  this->Shown.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  expectSameByCompute(this->Shown);
  clipObliquely(this->Shown);
  crop(this->Shown, VTK_CROP_FENCE);
  expectSameByCompute(this->Shown);
  this->Shown.drawCellScalars();
  expectSameByCompute(this->Shown);
}

TEST_F(Compute, WithTheCameraInside)
{
  lookFromInside(this->Shown.camera());
  expectSameByCompute(this->Shown);
}

TEST_F(Compute, InTilesAndAnyViewport)
{
  this->Shown.Renderer->SetViewport(0.3, 0.15, 0.95, 0.9);
  this->Shown.Mapper->SetMaxDrawTimeInSeconds(1e-9);
  expectSameByCompute(this->Shown);
  this->Shown.Window->SetSize(3, 2);
  expectSameByCompute(this->Shown);
}

TEST_F(Compute, WithFewerRays)
{
  this->Shown.Mapper->AutoAdjustSampleDistancesOff();
  this->Shown.Mapper->CollectDiagnosticsOff();
  this->Shown.Mapper->SetImageSampleDistance(3.0);
  this->Shown.Window->Render();
  const Image byFragments = this->Shown.frame();
  this->Shown.Mapper->SetShaderStageToCompute();
  this->Shown.Window->Render();
  EXPECT_EQ(this->Shown.Mapper->GetUsedShaderStage(), Mapper::COMPUTE_STAGE);
  EXPECT_EQ(byFragments.Rgba, this->Shown.frame().Rgba);
}

TEST_F(Compute, OfViewsAndPicks)
{
  for (const int mode :
    { Mapper::VIEW_CELLS, Mapper::VIEW_BOUNDARY_FACES, Mapper::VIEW_ILLUMINATION })
  {
    this->Shown.Mapper->SetViewMode(mode);
    this->Shown.Mapper->SetShaderStageToFragment();
    this->Shown.Window->Render();
    const Image byFragments = this->Shown.frame();
    this->Shown.Mapper->SetShaderStageToCompute();
    this->Shown.Window->Render();
    EXPECT_EQ(byFragments.Rgba, this->Shown.frame().Rgba) << mode;
  }
  this->Shown.Mapper->SetViewModeToPicture();
  EXPECT_TRUE(this->Shown.Mapper->Pick(this->Shown.Renderer, this->Shown.Volume, 50, 50));
}

// Few GPUs are faster by compute shaders, and the software renderer isn't one of them.
TEST_F(Compute, IsNotChosenWithoutNeed)
{
  this->Shown.Window->Render();
  const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  EXPECT_EQ(this->Shown.Mapper->GetUsedShaderStage(),
    tetmarch::hasFewFragmentUnits(renderer) ? Mapper::COMPUTE_STAGE : Mapper::FRAGMENT_STAGE)
    << renderer;
}

TEST_F(Compute, PictureTakesMemoryOnlyWhileItIsUsed)
{
  this->Shown.Mapper->CollectDiagnosticsOff();
  this->Shown.Mapper->SetShaderStageToFragment();
  this->Shown.Window->Render();
  const vtkTypeInt64 before = this->Shown.Mapper->GetGPUMemoryBytes();
  this->Shown.Mapper->SetShaderStageToCompute();
  this->Shown.Window->Render();
  EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), before + 16 * Side * Side);
  this->Shown.Mapper->SetShaderStageToFragment();
  this->Shown.Window->Render();
  EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), before);
}
} // namespace
