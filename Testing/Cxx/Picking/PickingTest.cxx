// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which points are picked, against closed forms.
#include "CutScene.h"
#include "EvenPick.h"

#include "vtkTransform.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

TEST(Picking, PointsOfEvenExtinction)
{
  auto scene = evenScene(hexLattice(4));
  for (const double threshold : { 0.1, 0.5, 0.9 })
  {
    expectClosedForm(*scene, threshold, RayTolerance, "perspective");
  }
  scene->camera()->ParallelProjectionOn();
  scene->camera()->SetParallelScale(0.9);
  scene->Window->Render();
  expectClosedForm(*scene, 0.5, RayTolerance, "parallel");
}

TEST(Picking, PointsOfEvenExtinctionInCells)
{
  auto scene = evenScene(mixedCells(4));
  scene->drawCellScalars();
  expectClosedForm(*scene, 0.5, RayTolerance, "cell scalars");
}

// Gradient opacity is 1/2 for all gradients, and halves the extinction everywhere.
TEST(Picking, PointsOfExtinctionByGradients)
{
  auto scene = evenScene(jitteredLattice(4));
  vtkNew<vtkPiecewiseFunction> half;
  half->AddPoint(0.0, 0.5);
  half->AddPoint(10.0, 0.5);
  scene->property()->SetGradientOpacity(half);
  for (const int type :
    { vtkTetMarchVolumeMapper::VERTEX_GRADIENTS, vtkTetMarchVolumeMapper::CELL_GRADIENTS })
  {
    scene->Mapper->SetGradientType(type);
    expectClosedForm(*scene, 0.5, RayTolerance, "gradient opacity", 0.5 * EvenExtinction);
  }
}

// Only what cropping and clipping leave adds to the opacity.
TEST(Picking, WhatIsCutAwayIsNotHit)
{
  auto scene = evenScene(jitteredLattice(5));
  for (const int flags : { VTK_CROP_SUBVOLUME, VTK_CROP_FENCE, VTK_CROP_INVERTED_CROSS, 0x5555555 })
  {
    crop(*scene, flags);
    expectClosedForm(*scene, 0.15, RayTolerance, "cropped");
  }
  scene->drawCellScalars();
  clipObliquely(*scene);
  expectClosedForm(*scene, 0.3, RayTolerance, "cells, cropped and clipped");
}

// What lies before the near plane is not hit, and adds nothing to the opacity.
TEST(Picking, CameraInside)
{
  auto scene = evenScene(jitteredLattice(5));
  scene->camera()->SetPosition(0.4, 0.45, 0.95);
  scene->camera()->SetFocalPoint(0.55, 0.5, 0.0);
  scene->camera()->SetViewUp(0.0, 1.0, 0.0);
  scene->camera()->SetClippingRange(0.02, 3.0);
  scene->Window->Render();
  expectClosedForm(*scene, 0.5, RayTolerance, "inside");
}

TEST(Picking, AViewportBesideAnother)
{
  auto scene = evenScene(jitteredLattice(5));
  scene->Window->SetSize(2 * SceneSize, SceneSize);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.0, 0.0, 0.5, 1.0);
  scene->Window->AddRenderer(other);
  scene->Renderer->SetViewport(0.5, 0.1, 1.0, 0.9);
  scene->Window->Render();
  expectClosedForm(*scene, 0.5, RayTolerance, "viewport");
  // Outside of the viewport, and outside of the window.
  EXPECT_FALSE(scene->pick(SceneSize / 2, SceneSize / 2));
  EXPECT_FALSE(scene->pick(-1, SceneSize / 2));
  EXPECT_FALSE(scene->pick(SceneSize, 3 * SceneSize));
}

// A threshold of 0 picks the first point that is seen, one of 1 the point behind which nothing is.
TEST(Picking, ThresholdsAtTheEnds)
{
  auto scene = evenScene(hexLattice(4));
  expectClosedForm(*scene, 0.0, RayTolerance, "first point");
  scene->Mapper->SetPickOpacityThreshold(1.0);
  EXPECT_FALSE(scene->pick(SceneSize / 2, SceneSize / 2));
  scene->property()->SetScalarOpacityUnitDistance(0.02);
  ASSERT_TRUE(scene->pick(SceneSize / 2, SceneSize / 2));
  const auto line = scene->lineOf(SceneSize / 2, SceneSize / 2);
  const double begin = distance(expectedOn(line, 0.0).Position, line.Near);
  EXPECT_NEAR(distance(scene->pickedPosition(), line.Near) - begin,
    std::log(double(1 << 24)) * 0.02 / Even::Opacity, 1e-4);
}

// Scalars below 0.5 are transparent.
TEST(Picking, WhatIsTransparentIsNotHit)
{
  PickScene scene(jitteredLattice(6));
  vtkPiecewiseFunction* opacity = scene.property()->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.5, 0.0);
  opacity->AddPoint(0.51, 1.0);
  scene.property()->SetScalarOpacityUnitDistance(1e-3);
  const Field field = linearField();
  int hits = 0;
  for (int x = 10; x < SceneSize; x += 10)
  {
    if (scene.pick(x, SceneSize / 2))
    {
      const Vec3 p = scene.pickedPosition();
      EXPECT_GT(field(p[0], p[1], p[2]), 0.5);
      ++hits;
    }
  }
  EXPECT_GT(hits, 4);
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.0, 0.0);
  EXPECT_TRUE(scene.selectAll().empty());
  EXPECT_FALSE(scene.pick(SceneSize / 2, SceneSize / 2));
}

// Picked points are in world coordinates, wherever the volume is.
TEST(Picking, AMovedVolume)
{
  auto scene = evenScene(jitteredLattice(5));
  ASSERT_TRUE(scene->pick(70, 85));
  const Vec3 before = scene->pickedPosition();
  const vtkIdType cell = scene->Mapper->GetPickedCellId();
  vtkNew<vtkTransform> place;
  place->Translate(10.0, -5.0, 3.0);
  place->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  place->Scale(3.0, 3.0, 3.0);
  scene->Volume->SetUserTransform(place);
  scene->camera()->ApplyTransform(place);
  scene->camera()->SetClippingRange(1.0, 40.0);
  scene->property()->SetScalarOpacityUnitDistance(3.0 * Even::UnitDistance);
  ASSERT_TRUE(scene->pick(70, 85));
  EXPECT_EQ(scene->Mapper->GetPickedCellId(), cell);
  Vec3 moved{};
  place->TransformPoint(before.data(), moved.data());
  EXPECT_LE(distance(scene->pickedPosition(), moved), 1e-4);
}

// A pick needs no frame before it, and takes nothing from one.
TEST(Picking, WithoutAFrameAndWithOtherData)
{
  PickScene scene(jitteredLattice(5));
  ASSERT_TRUE(scene.pick(70, 85));
  const vtkIdType cell = scene.Mapper->GetPickedCellId();
  const Grid other = hexLattice(3);
  scene.Mapper->SetInputData(other);
  ASSERT_TRUE(scene.pick(70, 85));
  EXPECT_LT(scene.Mapper->GetPickedCellId(), other->GetNumberOfCells());
  scene.Mapper->SetInputData(scene.Data);
  ASSERT_TRUE(scene.pick(70, 85));
  EXPECT_EQ(scene.Mapper->GetPickedCellId(), cell);
}
} // namespace
