// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Windows and mappers come and go in any order; pictures stay the same, and none frees what belongs
// to another.
#include "ErrorWatch.h"
#include "Held.h"
#include "NonConvexGrids.h"
#include "Scene.h"

#include "vtkActor.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

Grid lattice() { return jitteredLattice(6, 0.15, 1, sineField()); }

class Lifetime : public testing::Test
{
protected:
  Lifetime() { this->Expected = Scene(lattice()).render(); }

  void expectSame(const Image& picture) const
  {
    EXPECT_EQ(compare(picture, this->Expected).Max, 0.0);
  }

  // Another window with a renderer of its own that shows the scene's volume.
  static vtkSmartPointer<vtkRenderWindow> makeWindowOf(Scene& scene)
  {
    auto window = makeWindow();
    vtkNew<vtkRenderer> renderer;
    renderer->SetActiveCamera(scene.camera());
    renderer->AddVolume(scene.Volume);
    window->AddRenderer(renderer);
    return window;
  }

  Image renderIn(vtkRenderWindow* window, Scene& scene) const
  {
    window->Render();
    return floatPictureOf(scene.Mapper, SceneSize, SceneSize);
  }

  Image Expected;
};

TEST_F(Lifetime, ReleasedAndDrawnAgain)
{
  Scene scene(lattice());
  scene.render();
  const vtkTypeInt64 bytes = scene.Mapper->GetGPUMemoryBytes();
  EXPECT_GT(bytes, 0);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), 0);
  this->expectSame(scene.render());
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), bytes);
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
  scene.Mapper->ReleaseGraphicsResources(nullptr);
  this->expectSame(scene.render());
}

// Depths of opaque geometry, lists of entries, and the part that rays enter from inside.
TEST_F(Lifetime, WhatAFrameDoesNotNeedIsFreed)
{
  Scene scene(lattice());
  const auto drawFromInside = [&](bool parallel)
  {
    scene.camera()->SetPosition(0.5, 0.5, 0.6);
    scene.camera()->SetParallelProjection(parallel);
    scene.render();
  };
  const auto drawFromOutside = [&]
  {
    scene.camera()->ParallelProjectionOff();
    lookAtUnitCube(scene.camera());
    scene.render();
  };
  drawFromInside(true); // which makes the hierarchy that stays
  const Held inside(scene);
  drawFromOutside();
  const Held held(scene);
  EXPECT_LT(inside.Bytes, held.Bytes);
  drawFromInside(false);
  EXPECT_GT(scene.Mapper->GetGPUMemoryBytes(), held.Bytes);
  drawFromOutside();
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), held.Bytes);
  const auto ball = makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 });
  scene.Renderer->AddActor(ball);
  scene.render();
  EXPECT_GT(scene.Mapper->GetGPUMemoryBytes(), held.Bytes);
  scene.Renderer->RemoveActor(ball);
  scene.render();
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), held.Bytes);
  drawFromInside(true);
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), inside.Bytes);
}

// A search, here of a view of faces, reorders the boundary, through which rays enter again.
TEST_F(Lifetime, FromInsideBeforeAndAfterASearch)
{
  Scene scene(latticeWithHole(6, 0.15, 1, sineField()));
  scene.camera()->SetPosition(0.08, 0.1, 0.07);
  scene.camera()->SetFocalPoint(0.9, 0.8, 0.9);
  const Image before = scene.render();
  scene.Mapper->SetViewModeToBoundaryFaces();
  scene.Window->Render();
  scene.Mapper->SetViewModeToPicture();
  EXPECT_EQ(compare(scene.render(), before).Max, 0.0);
}

TEST_F(Lifetime, WindowFinalizedAndDrawnAgain)
{
  Scene scene(lattice());
  scene.render();
  scene.Window->Finalize();
  this->expectSame(scene.render());
  this->expectSame(scene.render());
}

TEST_F(Lifetime, SecondWindowAfterTheFirstIsFinalized)
{
  Scene scene(lattice());
  scene.render();
  scene.Window->Finalize();
  this->expectSame(this->renderIn(makeWindowOf(scene), scene));
}

TEST_F(Lifetime, TwoWindowsByTurns)
{
  Scene scene(lattice());
  const auto second = makeWindowOf(scene);
  for (int i = 0; i < 3; ++i)
  {
    this->expectSame(scene.render());
    this->expectSame(this->renderIn(second, scene));
  }
}

TEST_F(Lifetime, SecondWindowAfterTheFirstIsDeleted)
{
  Scene scene(lattice());
  scene.render();
  const auto second = makeWindowOf(scene);
  scene.Window = nullptr;
  this->expectSame(this->renderIn(second, scene));
}

TEST_F(Lifetime, SecondWindowAfterTheFirstIsDeletedWithItsRenderer)
{
  Scene scene(lattice());
  const auto second = makeWindowOf(scene);
  {
    const auto first = makeWindowOf(scene);
    this->expectSame(this->renderIn(first, scene));
  }
  this->expectSame(this->renderIn(second, scene));
}

TEST_F(Lifetime, MapperDeletedBeforeTheWindow)
{
  auto window = makeWindow();
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  lookAtUnitCube(renderer->GetActiveCamera());
  vtkNew<vtkVolume> volume;
  setBumpyFunctions(volume->GetProperty());
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.25);
  renderer->AddVolume(volume);
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkTetMarchVolumeMapper> mapper;
    mapper->SetInputData(lattice());
    mapper->CollectDiagnosticsOn();
    volume->SetMapper(mapper);
    window->Render();
    this->expectSame(floatPictureOf(mapper, SceneSize, SceneSize));
    volume->SetMapper(nullptr);
  }
}

TEST_F(Lifetime, VolumeRemovedBeforeTheWindowIsDeleted)
{
  Scene scene(lattice());
  scene.render();
  scene.Renderer->RemoveVolume(scene.Volume);
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), 0);
  scene.Window->Render();
  scene.Window = nullptr;
}

// GL names are small numbers: those of a context that is gone are likely those of things in
// another.
TEST_F(Lifetime, MapperOfADeletedWindowLeavesOtherWindowsAlone)
{
  Scene other(lattice());
  this->expectSame(other.render());
  auto mapper = vtkSmartPointer<vtkTetMarchVolumeMapper>::New();
  {
    Scene scene(lattice());
    mapper->SetInputData(scene.Data);
    scene.Volume->SetMapper(mapper);
    scene.Window->Render();
    scene.Volume->SetMapper(nullptr); // so that the window can't tell it to release anything
  }
  other.Window->MakeCurrent();
  mapper = nullptr;
  this->expectSame(other.render());
}

TEST_F(Lifetime, MapperOfAFinalizedWindowLeavesOtherWindowsAlone)
{
  Scene other(lattice());
  this->expectSame(other.render());
  Scene scene(lattice());
  {
    vtkNew<vtkTetMarchVolumeMapper> mapper;
    mapper->SetInputData(scene.Data);
    scene.Volume->SetMapper(mapper);
    scene.Window->Render();
    scene.Volume->SetMapper(scene.Mapper);
    scene.Window->Finalize();
    other.Window->MakeCurrent();
  }
  this->expectSame(other.render());
  this->expectSame(scene.render());
}

TEST_F(Lifetime, NeverDrawn)
{
  vtkNew<vtkTetMarchVolumeMapper> mapper;
  const ErrorWatch watch(mapper);
  EXPECT_EQ(mapper->GetNumberOfTetrahedra(), 0);
  EXPECT_EQ(mapper->GetGPUMemoryBytes(), 0);
  mapper->ReleaseGraphicsResources(makeWindow());
  EXPECT_TRUE(watch.Errors.empty());
}
} // namespace
