// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Volumes between translucent surfaces, which VTK peels off layer by layer.
#include "CutScene.h"
#include "PeeledScene.h"

#include "vtkLight.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using Peeling = PeeledScene;

TEST_F(Peeling, OneSurface) { this->expectPeeled({ Middle }); }

TEST_F(Peeling, SurfacesBeforeAndBehind)
{
  this->expectPeeled({ { 1.2, { { 0.9, 0.1, 0.1 } }, 0.4 } });
  this->expectPeeled({ { -0.2, { { 0.9, 0.1, 0.1 } }, 0.4 } });
}

TEST_F(Peeling, ThreeSurfaces) { this->expectPeeled({ Top, Middle, Low }); }

TEST_F(Peeling, BeforeOpaqueGeometry)
{
  this->expectPeeled({ Top, Low, Floor });
  this->expectPeeled({ Top, { 0.5, { { 0.1, 0.9, 0.3 } }, 1.0 } });
}

TEST_F(Peeling, CellScalars)
{
  this->Shown->drawCellScalars();
  this->expectPeeled({ Top, Low });
}

TEST_F(Peeling, ClippedAndCropped)
{
  clipObliquely(*this->Shown);
  this->expectPeeled({ Top, Middle, Low });
  crop(*this->Shown, VTK_CROP_FENCE);
  this->expectPeeled({ Top, Middle, Low });
}

TEST_F(Peeling, CameraInside)
{
  this->Shown->camera()->SetPosition(0.4, 0.45, 0.95);
  this->Shown->camera()->SetFocalPoint(0.55, 0.5, 0.0);
  this->Shown->camera()->SetViewUp(0.0, 1.0, 0.0);
  this->Shown->camera()->SetClippingRange(0.02, 3.0);
  this->expectPeeled({ Top, Low });
}

TEST_F(Peeling, ParallelProjection)
{
  this->Shown->camera()->ParallelProjectionOn();
  this->Shown->camera()->SetParallelScale(0.9);
  this->expectPeeled({ Top, Low });
}

TEST_F(Peeling, MeshWithAHole)
{
  this->use(latticeWithHole(9, 0.15, 1, sineField()));
  this->expectPeeled({ Top, Middle, Low });
}

TEST_F(Peeling, InLight)
{
  this->Shown->property()->ShadeOn();
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(3.0, 4.0, 5.0);
  this->Shown->Renderer->AddLight(sun);
  for (const int method :
    { vtkTetMarchVolumeMapper::SHADOWS_OFF, vtkTetMarchVolumeMapper::SHADOWS_AT_VERTICES })
  {
    this->Shown->Mapper->SetShadowMethod(method);
    // The planes of makePlane() are drawn without lighting.
    this->expectPeeled({ Top, Low });
  }
}

// Without translucent geometry, or where it alone is peeled, the volume is drawn at once.
TEST_F(Peeling, NothingToPeel)
{
  Scene& scene = *this->Shown;
  const Image picture = scene.render();
  const Image plain = scene.frame();
  this->peel(true);
  scene.Window->Render();
  expectSame(scene.frame(), plain, 1);
  scene.Renderer->AddActor(planeOf(Low, 0.5));
  scene.Renderer->UseDepthPeelingForVolumesOff();
  expectSame(scene.render(), picture, 0);
}

TEST_F(Peeling, AViewportBesideAnother)
{
  Scene& scene = *this->Shown;
  scene.Window->SetSize(2 * SceneSize, SceneSize);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.0, 0.0, 0.5, 1.0);
  scene.Window->AddRenderer(other);
  scene.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  scene.Renderer->AddActor(planeOf(Middle, 0.5));
  this->peel(true);
  scene.Window->Render();
  const Image beside = cropped(scene.frame(), SceneSize, 0, SceneSize, SceneSize);
  scene.Window->RemoveRenderer(other);
  scene.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  scene.Window->SetSize(SceneSize, SceneSize);
  scene.Window->Render();
  expectSame(beside, scene.frame(), 0);
}

// A frame without peels is the same as before there were any, and a second one with them makes
// nothing anew.
TEST_F(Peeling, LeavesNothingBehind)
{
  Scene& scene = *this->Shown;
  const Image before = scene.render();
  const auto plane = planeOf(Middle, 0.5);
  scene.Renderer->AddActor(plane);
  this->peel(true);
  scene.Window->Render();
  const Image peeled = scene.frame();
  const vtkTypeInt64 bytes = scene.Mapper->GetGPUMemoryBytes();
  scene.Window->Render();
  EXPECT_EQ(compare(peeled, scene.frame()).Max, 0.0);
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), bytes);
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
  EXPECT_EQ(scene.Mapper->GetTablesBuilds(), 1);
  scene.Renderer->RemoveActor(plane);
  this->peel(false);
  EXPECT_EQ(compare(before, scene.render()).Max, 0.0);
}
} // namespace
