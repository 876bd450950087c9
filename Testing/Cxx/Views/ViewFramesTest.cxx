// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Frames of the view modes: beside others, in tiles, and back to the picture.
#include "GLObjects.h"
#include "Observer.h"
#include "ViewScene.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;
using Statistics = vtkTetMarchFrameStatistics;

TEST(ViewMode, RenderersSideBySideAreAsAlone)
{
  ViewScene alone(viewLattice(), 100, 100);
  ViewScene both(viewLattice(), 200, 100);
  both.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  vtkNew<vtkRenderer> left;
  left->SetViewport(0.0, 0.0, 0.5, 1.0);
  left->SetBackground(0.2, 0.4, 0.6);
  vtkNew<vtkVolume> volume;
  vtkNew<vtkTetMarchVolumeMapper> mapper;
  mapper->SetInputData(both.Data);
  volume->SetMapper(mapper);
  volume->SetProperty(both.property());
  left->AddVolume(volume);
  lookAtUnitCube(left->GetActiveCamera());
  both.Window->AddRenderer(left);
  for (const auto& right : Views)
  {
    for (const int mode : { int(Mapper::VIEW_PICTURE), int(Mapper::VIEW_LOOKUPS) })
    {
      mapper->SetViewMode(mode);
      const Image frame = both.view(right.first);
      EXPECT_EQ(cropped(frame, 0, 0, 100, 100).Rgba, alone.view(mode).Rgba);
      EXPECT_EQ(cropped(frame, 100, 0, 100, 100).Rgba, alone.view(right.first).Rgba);
    }
  }
}

TEST(ViewMode, BackToThePictureNothingIsLeft)
{
  ViewScene scene(viewLattice());
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  const Image picture = scene.view(Mapper::VIEW_PICTURE);
  const auto objects = countGLObjects();
  const vtkTypeInt64 bytes = scene.Mapper->GetGPUMemoryBytes();
  for (int i = 0; i < 3; ++i)
  {
    for (const auto& [mode, quantity] : Views)
    {
      EXPECT_GT(compare(scene.view(mode), picture).Max, 0.1);
      EXPECT_GT(scene.Mapper->GetLastFrameStatistics()->GetNumberOfPixels(quantity), 0);
    }
    EXPECT_GT(countGLObjects()[0], objects[0]);
    EXPECT_GT(scene.Mapper->GetGPUMemoryBytes(), bytes);
    EXPECT_EQ(scene.view(Mapper::VIEW_PICTURE).Rgba, picture.Rgba);
    EXPECT_EQ(countGLObjects(), objects);
    EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), bytes);
    EXPECT_EQ(scene.Mapper->GetLastFrameStatistics()->GetNumberOfPixels(Statistics::CELLS), 0);
  }
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  const auto released = countGLObjects();
  const Image view = scene.view(Mapper::VIEW_CELLS);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(countGLObjects(), released);
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), 0);
  EXPECT_EQ(scene.view(Mapper::VIEW_CELLS).Rgba, view.Rgba);
}

TEST(ViewMode, DiagnosticsChangeNothing)
{
  ViewScene scene(viewLattice());
  const Image view = scene.view(Mapper::VIEW_LOOKUPS);
  scene.Mapper->CollectDiagnosticsOn();
  EXPECT_EQ(scene.view(Mapper::VIEW_LOOKUPS).Rgba, view.Rgba);
  EXPECT_EQ(floatPictureOf(scene.Mapper, SceneSize, SceneSize).Width, SceneSize);
  EXPECT_GT(scene.Mapper->GetLastFrameStatistics()->GetSeconds(), 0.0);
}

TEST(ViewMode, TilesAreTheFrameAndMayBeAborted)
{
  ViewScene scene(viewLattice());
  scene.Mapper->SetMaxDrawTimeInSeconds(0.0);
  const Image view = scene.view(Mapper::VIEW_CELLS);
  EXPECT_EQ(scene.Mapper->GetNumberOfDraws(), 1);
  scene.Mapper->SetMaxDrawTimeInSeconds(1e-9);
  EXPECT_EQ(scene.view(Mapper::VIEW_CELLS).Rgba, view.Rgba);
  const int draws = scene.Mapper->GetNumberOfDraws();
  EXPECT_GT(draws, 10);
  {
    const Observer observer(scene.Mapper, vtkCommand::ProgressEvent,
      [&] { scene.Window->SetAbortRender(scene.Mapper->GetProgress() < 1.0); });
    scene.Window->Render();
    EXPECT_GT(scene.Mapper->GetNumberOfDraws(), 0);
    EXPECT_LT(scene.Mapper->GetNumberOfDraws(), draws);
    EXPECT_EQ(scene.Mapper->GetNumberOfRays(), 0);
  }
  EXPECT_EQ(scene.view(Mapper::VIEW_CELLS).Rgba, view.Rgba);
}
} // namespace
