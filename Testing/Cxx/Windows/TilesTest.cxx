// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A frame in several draws is the same as in one draw, to the last bit, and can be aborted between
// two draws.
#include "ErrorWatch.h"
#include "Observer.h"
#include "Scene.h"

#include "vtkFloatArray.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace
{
using namespace tetmarch::testing;

Grid lattice() { return jitteredLattice(6, 0.15, 1, sineField()); }

// Of 160 x 160 pixels in the smallest tiles.
constexpr int MostDraws = 25;
constexpr double Tiny = 1e-9;
constexpr double Huge = 1e6;

// Bit for bit, in the window and in the diagnostic pixels.
void expectSameInTiles(Scene& scene, int leastDraws = MostDraws)
{
  scene.Mapper->SetMaxDrawTimeInSeconds(0.0);
  const Image picture = scene.render();
  const Image frame = scene.frame();
  EXPECT_EQ(scene.Mapper->GetNumberOfDraws(), 1);
  const vtkTypeInt64 rays = scene.Mapper->GetNumberOfRays();
  EXPECT_GT(rays, 0);
  for (const double limit : { Tiny, Huge, Tiny, 1e-3 })
  {
    scene.Mapper->SetMaxDrawTimeInSeconds(limit);
    const Image inTiles = scene.render();
    EXPECT_EQ(inTiles.Rgba, picture.Rgba) << limit;
    EXPECT_EQ(scene.frame().Rgba, frame.Rgba) << limit;
    EXPECT_EQ(scene.Mapper->GetNumberOfRays(), rays);
    if (limit == Tiny)
    {
      EXPECT_GE(scene.Mapper->GetNumberOfDraws(), leastDraws);
    }
    else if (limit == Huge)
    {
      EXPECT_EQ(scene.Mapper->GetNumberOfDraws(), 1); // the frame before told how long it takes
    }
  }
}

TEST(Tiles, AreTheFrame)
{
  for (const int samples : { 0, 8 })
  {
    Scene scene(lattice());
    scene.Window->SetMultiSamples(samples);
    scene.Renderer->SetBackground(0.2, 0.4, 0.6);
    expectSameInTiles(scene);
  }
}

TEST(Tiles, OfOddSizes)
{
  for (const auto& size : { std::pair(131, 77), std::pair(33, 200), std::pair(65, 33) })
  {
    Scene scene(lattice(), size.first, size.second);
    expectSameInTiles(scene, 2);
  }
}

TEST(Tiles, OfSmallPicturesAreOne)
{
  Scene scene(lattice(), 32, 32);
  scene.Mapper->SetMaxDrawTimeInSeconds(Tiny);
  scene.render();
  EXPECT_EQ(scene.Mapper->GetNumberOfDraws(), 1);
}

TEST(Tiles, AboutOpaqueGeometry)
{
  Scene scene(lattice());
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  expectSameInTiles(scene);
}

TEST(Tiles, WithTheCameraInside)
{
  Scene scene(latticeWithHole(6, 0.15, 1, sineField()));
  scene.camera()->SetPosition(0.05, 0.42, 0.57);
  scene.camera()->SetFocalPoint(1.0, 0.5, 0.5);
  scene.camera()->SetClippingRange(0.01, 5.0);
  expectSameInTiles(scene);
  scene.drawCellScalars();
  expectSameInTiles(scene);
}

TEST(Tiles, InViewportsAnywhere)
{
  Scene scene(lattice(), 240, 200);
  scene.Renderer->SetBackground(0.2, 0.4, 0.6);
  scene.Renderer->SetViewport(0.3, 0.15, 0.95, 0.9);
  expectSameInTiles(scene);

  vtkNew<vtkRenderer> left;
  left->SetViewport(0.0, 0.0, 0.3, 1.0);
  left->SetBackground(0.9, 0.4, 0.1);
  vtkNew<vtkVolume> volume;
  vtkNew<vtkTetMarchVolumeMapper> mapper;
  mapper->SetInputData(scene.Data);
  mapper->SetMaxDrawTimeInSeconds(Tiny);
  volume->SetMapper(mapper);
  volume->SetProperty(scene.property());
  left->AddVolume(volume);
  lookAtUnitCube(left->GetActiveCamera());
  scene.Window->AddRenderer(left);
  expectSameInTiles(scene);
  EXPECT_GT(mapper->GetNumberOfDraws(), 5);
}

TEST(Tiles, WithinALongLimitAreOne)
{
  Scene scene(lattice());
  scene.Mapper->SetMaxDrawTimeInSeconds(Huge);
  scene.render();
  EXPECT_EQ(scene.Mapper->GetNumberOfDraws(), 1);
  scene.camera()->Azimuth(10.0);
  scene.render();
  EXPECT_EQ(scene.Mapper->GetNumberOfDraws(), 1);
}

TEST(Tiles, TellProgress)
{
  Scene scene(lattice());
  scene.Mapper->SetMaxDrawTimeInSeconds(Tiny);
  scene.render();
  scene.Mapper->CollectDiagnosticsOff();
  std::vector<double> shares;
  const Observer observer(scene.Mapper, vtkCommand::ProgressEvent,
    [&] { shares.push_back(scene.Mapper->GetProgress()); });
  scene.Window->Render();
  // Before, vtkAlgorithm::Update() has told of 0 and 1.
  ASSERT_EQ(shares.size(), std::size_t(2 + MostDraws));
  EXPECT_TRUE(std::is_sorted(shares.begin() + 2, shares.end()));
  EXPECT_GT(shares[2], 0.0);
  EXPECT_LT(shares[MostDraws], 1.0);
  EXPECT_EQ(shares.back(), 1.0);
  shares.clear();
  scene.Mapper->SetMaxDrawTimeInSeconds(0.0);
  scene.Window->Render();
  EXPECT_EQ(shares.size(), 2u); // nobody waits long
}

class AbortedTiles : public testing::Test
{
protected:
  AbortedTiles()
  {
    this->Shown.Renderer->SetBackground(0.2, 0.4, 0.6);
    this->Shown.Mapper->SetMaxDrawTimeInSeconds(Tiny);
    this->Picture = this->Shown.render();
    this->Frame = this->Shown.frame();
    this->Shown.Mapper->CollectDiagnosticsOff();
    // Windows ask at most five times a second.
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
  }

  void expectWholeFrame()
  {
    this->Shown.Window->Render();
    EXPECT_EQ(this->Shown.Mapper->GetNumberOfDraws(), MostDraws);
    EXPECT_EQ(this->Shown.frame().Rgba, this->Frame.Rgba);
    this->Shown.Mapper->CollectDiagnosticsOn();
    EXPECT_EQ(this->Shown.render().Rgba, this->Picture.Rgba);
    EXPECT_EQ(this->Watch.Errors, std::vector<std::string>());
  }

  void abort() { this->Shown.Window->SetAbortRender(1); }

  Scene Shown{ lattice() };
  ErrorWatch Watch{ this->Shown.Mapper };
  Image Picture;
  Image Frame;
};

TEST_F(AbortedTiles, ByTheWindow)
{
  {
    const Observer observer(
      this->Shown.Window, vtkCommand::AbortCheckEvent, [this] { this->abort(); });
    this->Shown.Window->Render();
    EXPECT_EQ(this->Shown.Mapper->GetNumberOfDraws(), 1);
  }
  this->expectWholeFrame();
}

TEST_F(AbortedTiles, InTheMiddle)
{
  {
    const Observer observer(this->Shown.Mapper, vtkCommand::ProgressEvent,
      [this]
      {
        const double share = this->Shown.Mapper->GetProgress();
        if (share > 0.5 && share < 1.0)
        {
          this->abort();
        }
      });
    this->Shown.Window->Render();
    EXPECT_EQ(this->Shown.Mapper->GetNumberOfDraws(), MostDraws / 2 + 1);
  }
  this->expectWholeFrame();
}

TEST_F(AbortedTiles, OfTheCounters)
{
  this->Shown.Mapper->CollectDiagnosticsOn();
  {
    const Observer observer(
      this->Shown.Window, vtkCommand::AbortCheckEvent, [this] { this->abort(); });
    this->Shown.Window->Render();
    EXPECT_EQ(this->Shown.Mapper->GetNumberOfDraws(), 0);
    EXPECT_EQ(this->Shown.Mapper->GetNumberOfRays(), 0);
    vtkNew<vtkFloatArray> pixels;
    this->Shown.Mapper->GetDiagnosticPixels(pixels);
    EXPECT_EQ(pixels->GetNumberOfTuples(), 0);
  }
  this->Shown.Mapper->CollectDiagnosticsOff();
  this->expectWholeFrame();
}

TEST_F(AbortedTiles, WithoutALimitNobodyIsAsked)
{
  this->Shown.Mapper->SetMaxDrawTimeInSeconds(0.0);
  int asked = 0;
  const Observer observer(this->Shown.Window, vtkCommand::AbortCheckEvent, [&] { ++asked; });
  this->Shown.Window->Render();
  EXPECT_EQ(asked, 0);
  EXPECT_EQ(this->Shown.frame().Rgba, this->Frame.Rgba);
}

// Observers of progress may draw in other windows, or release what is being drawn.
TEST_F(AbortedTiles, ObserversMayDrawElsewhere)
{
  Scene other(lattice());
  {
    const Observer observer(
      this->Shown.Mapper, vtkCommand::ProgressEvent, [&] { other.Window->Render(); });
    this->Shown.Window->Render();
    EXPECT_EQ(this->Shown.Mapper->GetNumberOfDraws(), MostDraws);
    EXPECT_EQ(this->Shown.frame().Rgba, this->Frame.Rgba);
  }
  this->expectWholeFrame();
}

TEST_F(AbortedTiles, ObserversMayLeaveAnotherState)
{
  vtkOpenGLState* state = vtkOpenGLRenderWindow::SafeDownCast(this->Shown.Window)->GetState();
  {
    const Observer observer(this->Shown.Window, vtkCommand::AbortCheckEvent,
      [state]
      {
        state->vtkglViewport(3, 4, 50, 60);
        state->vtkglColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
        state->vtkglEnable(GL_SCISSOR_TEST);
        state->vtkglScissor(7, 8, 20, 30);
        state->vtkglBindFramebuffer(GL_FRAMEBUFFER, 0);
      });
    this->Shown.Window->Render();
    EXPECT_EQ(this->Shown.frame().Rgba, this->Frame.Rgba);
  }
  this->expectWholeFrame();
}

TEST_F(AbortedTiles, ObserversMayReleaseWhatIsDrawn)
{
  {
    const Observer observer(this->Shown.Mapper, vtkCommand::ProgressEvent,
      [this] { this->Shown.Mapper->ReleaseGraphicsResources(this->Shown.Window); });
    this->Shown.Window->Render();
    EXPECT_LE(this->Shown.Mapper->GetNumberOfDraws(), 1);
  }
  this->expectWholeFrame();
}
} // namespace
