// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws from every kind of camera and of every kind of volume matrix, and with opaque
// geometry in the volume, pixel by pixel against the CPU reference.
#include "CpuReference.h"

#include "vtkActor.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

Grid lattice() { return jitteredLattice(10, 0.15, 1, sineField()); }

TEST(ParityView, Parallel)
{
  Scene scene(lattice());
  scene.camera()->ParallelProjectionOn();
  scene.camera()->SetParallelScale(0.8);
  expectParity(scene);
}

TEST(ParityView, ParallelAlongAnAxisOfALattice)
{
  // Rays in the planes of faces, edges and vertices.
  Scene scene(jitteredLattice(8, 0.0, 1, sineField()));
  lookDownZ(scene.camera(), 0.625);
  expectParity(scene);
}

TEST(ParityView, OblongViewport)
{
  Scene scene(lattice(), 200, 90);
  expectParity(scene);
}

TEST(ParityView, CameraInside)
{
  Scene scene(lattice());
  lookFromInside(scene.camera());
  scene.property()->SetScalarOpacityUnitDistance(0.6);
  expectParity(scene);
}

TEST(ParityView, CameraInsideShellsAndParallel)
{
  Scene shells(nestedShells(10, 4, 0.15, 1, sineField()));
  lookFromInside(shells.camera());
  expectParity(shells);

  Scene parallel(lattice());
  lookFromInside(parallel.camera());
  parallel.camera()->ParallelProjectionOn();
  parallel.camera()->SetParallelScale(0.4);
  expectParity(parallel);
}

TEST(ParityView, NearPlaneCuts)
{
  Scene scene(latticeWithHole(9, 0.15, 1, sineField()));
  scene.camera()->SetClippingRange(2.8, 10.0);
  expectParity(scene);
}

TEST(ParityView, FarPlaneCuts)
{
  Scene scene(lattice());
  scene.camera()->SetClippingRange(1.0, 3.1);
  expectParity(scene);
}

TEST(ParityView, NearAndFarPlaneCut)
{
  Scene scene(lattice());
  scene.camera()->SetClippingRange(2.8, 3.2);
  expectParity(scene);
}

TEST(ParityView, WideAngle)
{
  Scene scene(lattice());
  scene.camera()->SetPosition(0.6, 0.55, 1.3);
  scene.camera()->SetViewAngle(140.0);
  scene.camera()->SetClippingRange(0.05, 10.0);
  expectParity(scene);
}

TEST(ParityView, NarrowAngleFromAfar)
{
  Scene scene(lattice());
  scene.camera()->SetPosition(700.5, 400.45, 600.5);
  scene.camera()->SetViewAngle(0.09);
  scene.camera()->SetClippingRange(900.0, 1100.0);
  expectParity(scene);
}

TEST(ParityView, Rotated)
{
  Scene scene(lattice());
  scene.Volume->SetOrigin(0.5, 0.5, 0.5);
  scene.Volume->RotateWXYZ(50.0, 1.0, 2.0, 3.0);
  scene.Volume->SetScale(0.8);
  expectParity(scene);
}

TEST(ParityView, MirroredConvexAndNot)
{
  vtkNew<vtkTransform> mirror;
  mirror->Translate(1.0, 0.0, 0.0);
  mirror->Scale(-1.0, 1.0, 1.0);
  for (const Grid& grid : { lattice(), latticeWithTunnel(9, 0.15, 1, sineField()) })
  {
    Scene scene(grid);
    scene.Volume->SetUserTransform(mirror);
    expectParity(scene);
  }
}

TEST(ParityView, StretchedAndSkewed)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(0.3, 0.4, 0.2);
  transform->RotateWXYZ(35.0, 1.0, 2.0, 3.0);
  transform->Scale(0.5, 1.4, -0.8);
  transform->RotateZ(25.0);
  Scene scene(lattice());
  scene.Volume->SetUserTransform(transform);
  expectParity(scene);
}

TEST(ParityView, OpaqueGeometryInside)
{
  Scene scene(lattice());
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 }));
  scene.Renderer->AddActor(makePlane(0.3, 0.4, { 0.0, 0.0, 0.0 }));
  expectParityWithOpaque(scene);
}

TEST(ParityView, OpaqueGeometryAndCameraInside)
{
  Scene scene(nestedShells(10, 4, 0.15, 1, sineField()));
  lookFromInside(scene.camera());
  scene.Renderer->AddActor(makeBall({ 0.9, 0.5, 0.4 }, 0.25, { 1.0, 1.0, 1.0 }));
  expectParityWithOpaque(scene);
}

TEST(ParityView, OpaqueGeometryInParallelProjection)
{
  Scene scene(latticeWithHole(9, 0.15, 1, sineField()));
  scene.camera()->ParallelProjectionOn();
  scene.camera()->SetParallelScale(0.8);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.3, { 1.0, 1.0, 1.0 }));
  expectParityWithOpaque(scene);
}

TEST(ParityView, NearPlaneVeryNear)
{
  // The depths of the rasteriser can't tell the front faces of the two components apart.
  Scene scene(twoComponents(6, 0.15, 1, sineField()));
  scene.camera()->SetPosition(4.5, 0.9, 1.3);
  for (const bool parallel : { false, true })
  {
    scene.camera()->SetParallelProjection(parallel);
    scene.camera()->SetClippingRange(0.5, 10.0);
    const Image fitting = scene.render();
    expectParity(scene);
    scene.camera()->SetClippingRange(parallel ? -1e8 : 1e-6, parallel ? 1e8 : 1000.0);
    // Without opaque geometry, and with some that hides nothing.
    const auto ball = makeBall({ 0.5, -0.5, 0.5 }, 0.1, { 1.0, 1.0, 1.0 });
    for (int i = 0; i < 2; ++i)
    {
      const Difference difference = compare(scene.render(), fitting);
      EXPECT_LE(difference.Max, 2.0 / 255.0) << difference.text();
      scene.Renderer->AddActor(ball);
    }
    scene.Renderer->RemoveActor(ball);
  }
}

TEST(ParityView, NearPlaneAtAThousandthOfTheFar)
{
  // As near as vtkRenderer::ResetCameraClippingRange() ever sets it.
  Scene scene(twoComponents(6, 0.15, 1, sineField()));
  scene.camera()->SetPosition(4.5, 0.9, 1.3);
  scene.camera()->SetClippingRange(0.02, 20.0);
  scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 }));
  expectParityWithOpaque(scene);
}
} // namespace
