// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// After VTK's TestGPURayCastClipping, TestGPURayCastClippingPolyData and
// TestGPURayCastClippingUserTransform.
#include "VtkScene.h"

#include "CpuReference.h"
#include "CutScene.h"

#include "vtkActor.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneCollection.h"

#include <memory>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 100;

vtkSmartPointer<vtkPlane> makePlaneAt(const Vec3& origin, const Vec3& normal)
{
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(origin.data());
  plane->SetNormal(normal.data());
  return plane;
}

// A volume of ours and one of the image that it was cut out of, with the same planes.
class Clipped : public testing::Test
{
protected:
  void show(vtkImageData* image)
  {
    this->Shown = std::make_unique<Scene>(tetrahedraOf(image), Side, Side);
    this->Shown->Mapper->SetOpacityLawToStructured();
    this->Shown->property()->SetScalarOpacityUnitDistance(1.0);
    this->Rival = makeImageMapper(image, 0.02);
    this->Shown->Mapper->SetClippingPlanes(this->Planes);
    this->Rival->SetClippingPlanes(this->Planes);
    vtkCamera* camera = this->Shown->camera();
    camera->SetPosition(0.0, 0.0, 1.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
  }

  vtkNew<vtkPlaneCollection> Planes;
  std::unique_ptr<Scene> Shown;
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> Rival;
};

TEST_F(Clipped, AWaveletByTwoPlanes)
{
  this->show(makeWavelet());
  setFunctions(this->Shown->property(), 40.0, 280.0, 0.4);
  this->Shown->camera()->Azimuth(-40.0);
  this->Shown->Renderer->ResetCamera();
  expectLike(*this->Shown, this->Rival, 2.0, "whole");
  this->Planes->AddItem(makePlaneAt({ 0.5, 0.0, 0.0 }, { 0.8, 0.0, 0.0 }));
  expectParity(*this->Shown);
  expectLike(*this->Shown, this->Rival, 2.0, "one plane");
  this->Planes->AddItem(makePlaneAt({ 0.5, 4.0, 0.0 }, { 0.2, -0.2, 0.0 }));
  expectParity(*this->Shown);
  expectLike(*this->Shown, this->Rival, 2.0, "two planes");
}

// A shell in light, opened to show a ball.
TEST_F(Clipped, AShellAboutABall)
{
  this->show(makeShell());
  vtkVolumeProperty* property = this->Shown->property();
  setFunctions(property, 50.0, 255.0, 1.0);
  property->ShadeOn();
  property->SetAmbient(0.1);
  property->SetDiffuse(0.7);
  property->SetSpecular(0.0); // before VTK 9.2 not as ours
  this->Shown->Renderer->SetBackground(0.2, 0.2, 0.5);
  const Vec3 centre{ 10.0, 10.0, 10.0 };
  this->Shown->Renderer->AddActor(makeBall(centre, 4.0, { 1.0, 1.0, 1.0 }));
  this->Planes->AddItem(makePlaneAt(centre, { -1.0, 0.0, 0.0 }));
  this->Planes->AddItem(makePlaneAt(centre, { -0.2, 0.2, 0.0 }));
  this->Shown->Renderer->ResetCamera();
  this->Shown->camera()->Azimuth(30.0);
  this->Shown->camera()->Elevation(-25.0);
  this->Shown->Renderer->ResetCameraClippingRange();
  expectParityWithOpaque(*this->Shown);
  expectLike(*this->Shown, this->Rival, 6.0);
}

// The greatest value in a slab of a volume that stands upright by a matrix; the slab turns with the
// camera.
TEST_F(Clipped, ASlabThatFollowsTheCamera)
{
  this->show(makeWavelet());
  Scene& scene = *this->Shown;
  setFunctions(scene.property(), 40.0, 280.0, 1.0);
  scene.Mapper->SetBlendMode(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
  this->Rival->SetBlendModeToMaximumIntensity();
  vtkNew<vtkMatrix4x4> upright;
  const double rows[16] = { 0, 0, -1, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 1 };
  upright->DeepCopy(rows);
  scene.Volume->SetUserMatrix(upright);
  const auto front = makePlaneAt({}, { 0.0, 0.0, -1.0 }), rear = makePlaneAt({}, { 0.0, 0.0, 1.0 });
  this->Planes->AddItem(front);
  this->Planes->AddItem(rear);
  vtkCamera* camera = scene.camera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(15.0);
  scene.Renderer->ResetCamera();
  scene.render();
  const vtkTypeInt64 bytes = scene.Mapper->GetUploadedBytes();
  for (const double turn : { 0.0, 25.0, 40.0 })
  {
    camera->Azimuth(turn);
    camera->Elevation(0.5 * turn);
    camera->OrthogonalizeViewUp();
    const double* towards = camera->GetViewPlaneNormal();
    front->SetOrigin(1.5 * towards[0], 1.5 * towards[1], 1.5 * towards[2]);
    rear->SetOrigin(-1.5 * towards[0], -1.5 * towards[1], -1.5 * towards[2]);
    front->SetNormal(-towards[0], -towards[1], -towards[2]);
    rear->SetNormal(towards[0], towards[1], towards[2]);
    scene.Renderer->ResetCameraClippingRange();
    expectParity(scene);
    expectLike(scene, this->Rival, 4.0);
  }
  EXPECT_EQ(scene.Mapper->GetUploadedBytes(), bytes);
}
} // namespace
