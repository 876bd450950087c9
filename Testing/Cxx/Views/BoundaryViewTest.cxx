// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The view modes of the boundary: each pixel shows by which face its ray enters, and where.
#include "BoundaryParity.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;

TEST(BoundaryView, IsAsTheReferenceHasIt)
{
  for (const int samples : { 0, 8 })
  {
    BoundaryScene scene(boundaryLattice());
    scene.Window->SetMultiSamples(samples);
    EXPECT_GT(expectAsReference(scene), 4000);
  }
  BoundaryScene parallel(boundaryLattice());
  parallel.camera()->ParallelProjectionOn();
  parallel.camera()->SetParallelScale(0.9);
  EXPECT_GT(expectAsReference(parallel), 4000);
  BoundaryScene mirrored(boundaryLattice());
  mirrored.Volume->SetScale(-1.0, 1.0, 1.0);
  mirrored.Volume->SetPosition(1.0, 0.0, 0.0);
  EXPECT_GT(expectAsReference(mirrored), 4000);
}

TEST(BoundaryView, OfNonConvexMeshes)
{
  for (const Grid& grid : { latticeWithHole(6), latticeWithTunnel(6), lShape(6), twoComponents(6) })
  {
    BoundaryScene scene(grid);
    EXPECT_GT(expectAsReference(scene), 2000);
  }
}

TEST(BoundaryView, InAViewportOffTheCorner)
{
  BoundaryScene scene(latticeWithHole(6), 240, 200);
  scene.Renderer->SetViewport(0.3, 0.15, 0.95, 0.9);
  EXPECT_GT(expectAsReference(scene), 4000);
  scene.camera()->SetClippingRange(2.4, 10.0); // searched for
  EXPECT_GT(expectAsReference(scene), 4000);
}

// The near plane cuts the mesh: pixels show the face behind the camera by which the ray entered or,
// if the camera is in the hole, the next face that it enters by.
TEST(BoundaryView, CameraInside)
{
  BoundaryScene scene(latticeWithHole(6));
  scene.camera()->SetClippingRange(0.01, 5.0);
  const Vec3 places[] = { { { 0.05, 0.42, 0.57 } }, { { 0.52, 0.49, 0.48 } } };
  for (const Vec3& place : places)
  {
    scene.camera()->SetPosition(place.data());
    scene.camera()->SetFocalPoint(1.0, 0.55, 0.45);
    EXPECT_EQ(expectAsReference(scene), SceneSize * SceneSize);
  }
}

// In the box about the mesh, but not in the mesh: nothing of what lies behind is seen.
TEST(BoundaryView, CameraBetween)
{
  BoundaryScene scene(lShape(6));
  scene.camera()->SetClippingRange(0.001, 5.0);
  scene.camera()->SetPosition(0.8, 0.8, 0.5);
  int inside[2];
  for (int away = 0; away < 2; ++away)
  {
    scene.camera()->SetFocalPoint(away ? 1.8 : 0.2, away ? 1.8 : 0.2, 0.55);
    inside[away] = expectAsReference(scene);
  }
  EXPECT_GT(inside[0], 1000);
  EXPECT_LT(inside[1], inside[0]);
}

// The first cut of the near plane makes the hierarchy, which numbers faces anew: colours stay.
TEST(BoundaryView, NearPlaneChangesNoColor)
{
  BoundaryScene scene(boundaryLattice());
  const Image before = scene.view(Mapper::VIEW_BOUNDARY_FACES);
  scene.camera()->SetClippingRange(2.4, 10.0);
  EXPECT_LE(compare(scene.view(Mapper::VIEW_BOUNDARY_FACES), before).Over, 20u);
}

TEST(BoundaryView, OpaqueGeometryHidesWhatIsBehind)
{
  for (const Grid& grid : { boundaryLattice(), latticeWithHole(6) })
  {
    BoundaryScene scene(grid);
    const int whole = expectAsReference(scene);
    const auto ball = makeBall({ 0.5, 0.95, 0.9 }, 0.3, { 0.1, 0.1, 0.1 });
    scene.Renderer->AddActor(ball);
    const int before = expectAsReference(scene, true);
    EXPECT_GT(before, whole / 3);
    EXPECT_LT(before, whole - 500);
    scene.camera()->SetClippingRange(2.4, 10.0); // searched for
    EXPECT_LT(expectAsReference(scene, true), whole - 500);
    scene.camera()->SetClippingRange(0.5, 10.0);
    scene.Renderer->RemoveActor(ball);
    // What is inside hides nothing.
    const Image alone = scene.view(Mapper::VIEW_BOUNDARY_FACES);
    scene.Renderer->AddActor(makeBall({ 0.5, 0.5, 0.5 }, 0.3, { 0.1, 0.1, 0.1 }));
    EXPECT_EQ(compare(scene.view(Mapper::VIEW_BOUNDARY_FACES), alone).Max, 0.0);
  }
}
} // namespace
