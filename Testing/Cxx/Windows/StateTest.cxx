// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The GL state is after a frame of the mapper as it was before, both in the GL and in VTK's
// records.
#include "GLObjects.h"
#include "Observer.h"
#include "Scene.h"
#include "WatchedMapper.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"
#include "vtkSelection.h"

#include <array>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

// With diagnostics or without, and in which view mode.
constexpr std::pair<bool, int> WaysToDraw[] = { { true, vtkTetMarchVolumeMapper::VIEW_PICTURE },
  { false, vtkTetMarchVolumeMapper::VIEW_PICTURE },
  { false, vtkTetMarchVolumeMapper::VIEW_ERROR_BOUND },
  { false, vtkTetMarchVolumeMapper::VIEW_BOUNDARY_FACES } };

void expectStateKept(Scene& scene, int stage = vtkTetMarchVolumeMapper::AUTOMATIC_STAGE)
{
  const bool multisampled = scene.Window->GetMultiSamples() > 1;
  for (const auto& [diagnostics, viewMode] : WaysToDraw)
  {
    vtkNew<WatchedMapper> mapper;
    mapper->SetInputData(scene.Data);
    mapper->SetCollectDiagnostics(diagnostics);
    mapper->SetViewMode(viewMode);
    mapper->SetShaderStage(stage);
    scene.Volume->SetMapper(mapper);
    scene.Window->Render();
    scene.Window->Render();
    EXPECT_EQ(mapper->Frames, 2);
    EXPECT_EQ(unitsInUse(scene.Window), 0);
    EXPECT_EQ(mapper->Samples > 1, multisampled);
    scene.Volume->SetMapper(scene.Mapper);
  }
}

Grid lattice() { return jitteredLattice(5, 0.15, 1, sineField()); }

TEST(GLState, IsKept)
{
  for (const int samples : { 0, 8 })
  {
    Scene scene(lattice());
    scene.Window->SetMultiSamples(samples);
    expectStateKept(scene);
    scene.Renderer->SetViewport(0.2, 0.3, 0.7, 0.9);
    expectStateKept(scene);
    scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
    expectStateKept(scene);
  }
}

// Nothing is drawn then, but VTK's records name objects as bound that are gone.
TEST(GLState, IsKeptIfSomebodyReleasesWhatIsDrawn)
{
  Scene scene(lattice());
  for (const auto& [diagnostics, viewMode] : WaysToDraw)
  {
    vtkNew<WatchedMapper> mapper;
    mapper->SetInputData(scene.Data);
    mapper->SetCollectDiagnostics(diagnostics);
    mapper->SetViewMode(viewMode);
    mapper->SetMaxDrawTimeInSeconds(1e-9);
    scene.Volume->SetMapper(mapper);
    scene.Window->Render();
    EXPECT_GT(mapper->GetGPUMemoryBytes(), 0);
    {
      const Observer observer(
        mapper, vtkCommand::ProgressEvent, [&] { mapper->ReleaseGraphicsResources(scene.Window); });
      scene.Window->Render();
      EXPECT_EQ(mapper->GetGPUMemoryBytes(), 0);
    }
    scene.Window->Render();
    EXPECT_EQ(mapper->Frames, 3);
    scene.Volume->SetMapper(scene.Mapper);
  }
}

// The GL state as translucent surfaces leave it.
TEST(GLState, KeepsTheTextureUnit)
{
  Scene scene(lattice());
  vtkNew<WatchedMapper> mapper;
  mapper->SetInputData(scene.Data);
  scene.Volume->SetMapper(mapper);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(scene.Window);
  const Observer observer(scene.Renderer, vtkCommand::StartEvent,
    [&] { window->GetState()->vtkglActiveTexture(GL_TEXTURE3); });
  scene.Window->Render();
  scene.Window->Render();
  EXPECT_EQ(mapper->Frames, 2);
  scene.Volume->SetMapper(scene.Mapper);
}

class TargetsMapper : public vtkTetMarchVolumeMapper
{
public:
  static TargetsMapper* New();
  void Render(vtkRenderer* renderer, vtkVolume* volume) override
  {
    const auto before = buffers();
    EXPECT_NE(before[1], GL_NONE);
    this->vtkTetMarchVolumeMapper::Render(renderer, volume);
    EXPECT_EQ(buffers(), before);
    ++this->Frames;
  }
  int Frames = 0;

private:
  static std::array<int, 3> buffers()
  {
    std::array<int, 3> found{};
    for (int i = 0; i < 3; ++i)
    {
      glGetIntegerv(GL_DRAW_BUFFER0 + i, &found[i]);
    }
    return found;
  }
};
vtkStandardNewMacro(TargetsMapper);

// For colours, positions and normals.
TEST(GLState, TargetsOfAPassAreKept)
{
  Scene scene(lattice());
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAOPass> pass;
  pass->SetDelegatePass(steps);
  scene.Renderer->SetPass(pass);
  vtkNew<TargetsMapper> mapper;
  mapper->SetInputData(scene.Data);
  scene.Volume->SetMapper(mapper);
  scene.Window->Render();
  EXPECT_EQ(mapper->Frames, 1);
  scene.Volume->SetMapper(scene.Mapper);
  pass->ReleaseGraphicsResources(scene.Window);
}

TEST(GLState, IsKeptBySelections)
{
  Scene scene(lattice());
  scene.Renderer->SetViewport(0.2, 0.3, 0.7, 0.9);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  vtkNew<WatchedMapper> mapper;
  mapper->SetInputData(scene.Data);
  scene.Volume->SetMapper(mapper);
  scene.Window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(20, 20, 140, 120);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  EXPECT_EQ(selection->GetNumberOfNodes(), 2u);
  EXPECT_GE(mapper->Frames, 5);
}

// A selector makes VTK record which buffers are bound, and VTK never forgets them.
TEST(GLState, NeedsNoBuffersOfThingsThatAreGone)
{
  Scene scene(lattice());
  scene.Renderer->RemoveVolume(scene.Volume);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(20, 20, 140, 120);
  for (int i = 0; i < 2; ++i)
  {
    const auto ball = makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 });
    scene.Renderer->AddActor(ball);
    scene.Window->Render();
    vtkSmartPointer<vtkSelection>::Take(selector->Select());
    scene.Renderer->RemoveActor(ball);
    ball->ReleaseGraphicsResources(scene.Window);
    scene.Renderer->AddVolume(scene.Volume);
    scene.Window->Render();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    scene.Renderer->RemoveVolume(scene.Volume);
  }
}

TEST(GLState, IsKeptWithSearchedEntriesAndCellScalars)
{
  Scene scene(latticeWithHole(6, 0.15, 1, sineField()));
  scene.camera()->SetClippingRange(2.8, 3.2);
  expectStateKept(scene);
  scene.drawCellScalars();
  expectStateKept(scene);
}

TEST(GLState, IsKeptByComputeShaders)
{
  Scene scene(lattice());
  scene.Renderer->SetViewport(0.2, 0.3, 0.7, 0.9);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  scene.Mapper->SetShaderStageToCompute();
  scene.render();
  ASSERT_EQ(scene.Mapper->GetUsedShaderStage(), vtkTetMarchVolumeMapper::COMPUTE_STAGE);
  expectStateKept(scene, vtkTetMarchVolumeMapper::COMPUTE_STAGE);
}

TEST(GLState, IsKeptByTilesAndWhenTheyAreAborted)
{
  Scene scene(lattice());
  scene.Renderer->SetViewport(0.2, 0.3, 0.7, 0.9);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  for (const auto& [diagnostics, viewMode] : WaysToDraw)
  {
    vtkNew<WatchedMapper> mapper;
    mapper->SetInputData(scene.Data);
    mapper->SetCollectDiagnostics(diagnostics);
    mapper->SetViewMode(viewMode);
    mapper->SetMaxDrawTimeInSeconds(1e-9);
    scene.Volume->SetMapper(mapper);
    scene.Window->Render();
    const int draws = mapper->GetNumberOfDraws();
    EXPECT_GT(draws, 1);
    const Observer observer(mapper, vtkCommand::ProgressEvent,
      [&] { scene.Window->SetAbortRender(mapper->GetProgress() < 1.0); });
    scene.Window->Render();
    EXPECT_LT(mapper->GetNumberOfDraws(), draws);
    EXPECT_EQ(mapper->Frames, 2);
    scene.Volume->SetMapper(scene.Mapper);
  }
}

TEST(GLState, IsKeptWhenNothingIsDrawn)
{
  Scene scene(lattice());
  vtkNew<WatchedMapper> mapper;
  mapper->SetInputData(scene.Data);
  scene.Volume->SetMapper(mapper);
  setPlainFunctions(scene.property(), { 1.0, 1.0, 1.0 }, 0.0);
  scene.Window->Render();
  EXPECT_EQ(mapper->Frames, 1);
}

// VTK skips glUseProgram() if it believes a program is in use already.
TEST(GLState, OtherPropsAreDrawnAsWithoutIt)
{
  const auto makeRight = []
  {
    vtkNew<vtkRenderer> right;
    right->SetViewport(0.5, 0.0, 1.0, 1.0);
    lookAtUnitCube(right->GetActiveCamera());
    right->AddActor(makePlane(0.2, 0.0, { 0.1, 0.9, 0.3 }));
    const auto glass = makeBall({ 0.5, 0.5, 0.5 }, 0.4, { 1.0, 0.2, 0.2 });
    glass->GetProperty()->SetOpacity(0.5);
    right->AddActor(glass);
    return vtkSmartPointer<vtkRenderer>(right);
  };
  Scene scene(lattice(), 200, 100);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  scene.Window->AddRenderer(makeRight());
  scene.Window->Render();
  scene.Window->Render();

  const auto other = makeWindow(200, 100);
  other->AddRenderer(makeRight());
  other->Render();
  const Image a = cropped(framePictureOf(scene.Window), 100, 0, 100, 100);
  const Image b = cropped(framePictureOf(other), 100, 0, 100, 100);
  EXPECT_EQ(compare(a, b, {}, 0.0, Channels::Rgb).Max, 0.0);
  EXPECT_GT(compare(a, Image(100, 100)).Max, 0.5);
}
} // namespace
