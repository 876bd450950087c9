// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Fewer rays than pixels, while somebody interacts.
#include "ScarceTime.h"
#include "Scene.h"

#include "vtkActor.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

class Coarse : public testing::Test
{
protected:
  Coarse()
  {
    this->Shown.Mapper->CollectDiagnosticsOff();
    this->Shown.Renderer->SetBackground(0.2, 0.4, 0.6);
  }
  Image draw(double distance)
  {
    this->Shown.Mapper->AutoAdjustSampleDistancesOff();
    this->Shown.Mapper->SetImageSampleDistance(distance);
    return this->draw();
  }
  Image draw()
  {
    this->Shown.Window->Render();
    return this->Shown.frame();
  }
  double used() { return this->Shown.Mapper->GetUsedImageSampleDistance(); }

  Scene Shown{ jitteredLattice(8, 0.15, 1, sineField()) };
};

// A pixel in the middle of a coarse pixel has its colour; others have a mixture of the nearest.
TEST_F(Coarse, IsLikeTheFullPicture)
{
  const Image full = this->draw(1.0);
  double last = 0.0;
  for (const double distance : { 1.5, 2.0, 4.0, 10.0 })
  {
    const Image coarse = this->draw(distance);
    EXPECT_EQ(this->used(), distance);
    const Difference difference = compare(full, coarse, {}, 2.0 / 255.0, Channels::Rgb);
    std::cout << "[ MEASURED ] " << distance << ": " << difference.text() << '\n';
    EXPECT_GT(difference.Rms, last) << distance;
    EXPECT_LT(difference.Rms, 0.0045 * distance) << distance;
    last = difference.Rms;
  }
  EXPECT_EQ(compare(full, this->draw(1.0)).Max, 0.0);
}

// Every third pixel lies in the middle of a coarse pixel and has the same ray.
TEST_F(Coarse, RaysAreThoseOfPixels)
{
  Scene scene(jitteredLattice(8, 0.15, 1, sineField()), 150, 150);
  scene.Mapper->CollectDiagnosticsOff();
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  const auto draw = [&](double distance)
  {
    scene.Mapper->AutoAdjustSampleDistancesOff();
    scene.Mapper->SetImageSampleDistance(distance);
    scene.Window->Render();
    return scene.frame();
  };
  const Image full = draw(1.0);
  const Image coarse = draw(3.0);
  Mask middles(150 * 150, false);
  for (int y = 1; y < 150; y += 3)
  {
    for (int x = 1; x < 150; x += 3)
    {
      middles[150 * y + x] = true;
    }
  }
  const Difference difference = compare(full, coarse, middles, 2.0 / 255.0, Channels::Rgb);
  std::cout << "[ MEASURED ] " << difference.text() << '\n';
  EXPECT_LE(difference.Max, 1.5 / 255.0) << difference.text();
  EXPECT_GT(compare(full, coarse).Max, 0.1);
}

TEST_F(Coarse, OneRayForAll)
{
  this->Shown.Window->SetSize(7, 5);
  const Image picture = this->draw(100.0);
  for (std::size_t i = 4; i < picture.Rgba.size(); ++i)
  {
    ASSERT_EQ(picture.Rgba[i], picture.Rgba[i % 4]);
  }
}

// The desired update rate decides, at rest all rays are there; nothing is rebuilt.
TEST_F(Coarse, KeepsTheDesiredUpdateRate)
{
  const Image still = this->draw();
  EXPECT_EQ(this->used(), 1.0);
  this->Shown.Window->SetDesiredUpdateRate(1e6);
  this->draw();
  EXPECT_EQ(this->used(), 10.0);
  this->Shown.Mapper->SetMaximumImageSampleDistance(3.0);
  this->draw();
  EXPECT_EQ(this->used(), 3.0);
  this->Shown.Mapper->AutoAdjustSampleDistancesOff();
  this->draw();
  EXPECT_EQ(this->used(), 1.0);
  this->Shown.Mapper->AutoAdjustSampleDistancesOn();
  this->Shown.Window->SetDesiredUpdateRate(0.001);
  EXPECT_EQ(compare(still, this->draw()).Max, 0.0);
  EXPECT_EQ(this->used(), 1.0);
  EXPECT_EQ(this->Shown.Mapper->GetMeshBuilds(), 1);
  EXPECT_EQ(this->Shown.Mapper->GetTablesBuilds(), 1);
}

// VTK allocates time at rest, too: a part of what the still rate leaves. A frame may take longer.
TEST_F(Coarse, AllRaysAtRestHoweverLongTheyTake)
{
  makeTimeScarce(this->Shown.Renderer);
  for (const double atRest : { 0.0001, 0.002, 0.5 }) // of interactors, of ParaView
  {
    this->Shown.Window->SetDesiredUpdateRate(atRest);
    const Image still = this->draw();
    EXPECT_EQ(this->used(), 1.0);
    EXPECT_LT(this->Shown.Volume->GetAllocatedRenderTime(), 1e-20);
    EXPECT_EQ(compare(still, this->draw()).Max, 0.0);
    EXPECT_EQ(this->used(), 1.0);
    this->Shown.Window->SetDesiredUpdateRate(5.0);
    this->draw();
    EXPECT_EQ(this->used(), 10.0);
  }
  this->Shown.Mapper->SetMinimumImageSampleDistance(2.0);
  this->Shown.Window->SetDesiredUpdateRate(0.002);
  this->draw();
  EXPECT_EQ(this->used(), 2.0) << "that is asked for";
}

TEST_F(Coarse, AllRaysWhereTheyAreCounted)
{
  this->Shown.Mapper->CollectDiagnosticsOn();
  this->draw(4.0);
  EXPECT_EQ(this->used(), 1.0);
  EXPECT_GT(this->Shown.Mapper->GetNumberOfRays(), 1000);
  this->Shown.Mapper->CollectDiagnosticsOff();
  this->Shown.Mapper->SetViewModeToCells();
  this->draw(4.0);
  EXPECT_EQ(this->used(), 1.0);
  this->Shown.Mapper->SetViewModeToPicture();
  this->draw(4.0);
  EXPECT_EQ(this->used(), 4.0);
}

// The coarse picture takes room on the GPU only while it is used.
TEST_F(Coarse, IsFreedAtRest)
{
  this->Shown.Mapper->SetShaderStageToFragment(); // a compute shader's picture takes room, too
  this->draw(1.0);
  const vtkTypeInt64 before = this->Shown.Mapper->GetGPUMemoryBytes();
  this->draw(1.0 + 1e-9); // as many rays
  const vtkTypeInt64 pixels = SceneSize * SceneSize;
  EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), before + 8 * pixels);
  this->draw(1.0);
  EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), before);
}

TEST_F(Coarse, InAViewportOverOpaqueGeometry)
{
  Scene& scene = this->Shown;
  scene.Window->SetSize(2 * SceneSize, SceneSize);
  scene.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  scene.Renderer->AddActor(makePlane(0.5, 0.2, { 1.0, 1.0, 1.0 }));
  const Image beside = cropped(this->draw(2.0), SceneSize, 0, SceneSize, SceneSize);
  scene.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  scene.Window->SetSize(SceneSize, SceneSize);
  EXPECT_LE(compare(beside, this->draw(2.0), {}, 0.0, Channels::Rgb).Max, 1.0 / 255.0);
}
} // namespace
