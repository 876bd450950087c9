// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws with each effect of light, pixel by pixel against the CPU reference.
#include "CpuReference.h"
#include "Lights.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 80;

// The bumpy functions, shaded by all of the property's numbers.
class LightParity : public testing::Test
{
protected:
  void use(vtkUnstructuredGrid* grid)
  {
    this->Shown = std::make_unique<Scene>(grid, Side, Side);
    setShading(this->Shown->property());
  }
  LightParity() { this->use(jitteredLattice(10, 0.15, 1, sineField())); }
  // A headlight, which is what there is if nobody has set a light, shines in another direction.
  void addSun() { addLight(*this->Shown, 3.0, 4.0, 1.5); }

  std::unique_ptr<Scene> Shown;
};

TEST_F(LightParity, Headlight) { expectParity(*this->Shown); }

TEST_F(LightParity, DimColouredHeadlight)
{
  addDimColouredHeadlight(this->Shown->Renderer);
  expectParity(*this->Shown);
}

TEST_F(LightParity, OneSide)
{
  this->Shown->Renderer->TwoSidedLightingOff();
  this->addSun();
  expectParity(*this->Shown);
}

TEST_F(LightParity, ParallelProjection)
{
  this->Shown->camera()->ParallelProjectionOn();
  this->Shown->camera()->SetParallelScale(0.9);
  expectParity(*this->Shown);
}

TEST_F(LightParity, LightsOfAllKinds)
{
  Scene& scene = *this->Shown;
  this->addSun();
  addFadingLight(scene.Renderer);
  addSpotlight(scene.Renderer);
  addCameraLight(scene.Renderer);
  addFillLight(scene.Renderer);
  vtkLight* off = addLight(scene, 0.0, 9.0, 0.0);
  off->SwitchOff();
  expectParity(scene);
}

TEST_F(LightParity, StretchedAndTurnedVolume)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(0.1, 0.05, 0.0);
  transform->RotateWXYZ(30.0, 1.0, 2.0, 3.0);
  transform->Scale(1.0, 0.5, 0.8);
  this->Shown->Volume->SetUserTransform(transform);
  addPointLight(this->Shown->Renderer, -0.2, 1.4, 0.9);
  this->Shown->Mapper->SetShadowMethodToAtVertices();
  expectParity(*this->Shown);
}

// A volume that is hardly stretched looks like one that isn't, though its light is computed in the
// frame of the world.
TEST_F(LightParity, LightInTheWorldIsThatInTheMesh)
{
  Scene& scene = *this->Shown;
  vtkNew<vtkTransform> transform;
  scene.Volume->SetUserTransform(transform);
  scene.Mapper->SetShadowMethodToAtVertices();
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  scene.Renderer->AddLight(head);
  for (const bool sunny : { false, true })
  {
    SCOPED_TRACE(sunny);
    if (sunny)
    {
      scene.Renderer->RemoveLight(head);
      this->addSun();
    }
    Image pictures[2];
    for (const int stretched : { 0, 1 })
    {
      transform->Identity();
      transform->Translate(0.1, 0.05, 0.0);
      transform->RotateWXYZ(30.0, 1.0, 2.0, 3.0);
      transform->Scale(-0.8, 0.8, 0.8);
      transform->Scale(stretched ? 1.00002 : 1.0, 1.0, 1.0);
      SCOPED_TRACE(stretched);
      expectParity(scene);
      pictures[stretched] = scene.frame();
    }
    const Difference difference = compare(pictures[0], pictures[1]);
    std::printf("%s\n", difference.text().c_str());
    EXPECT_LE(difference.Rms, 0.3 / 255.0);
  }
}

TEST_F(LightParity, GradientOpacityUnlit)
{
  this->Shown->property()->ShadeOff();
  setGradientOpacity(this->Shown->property());
  expectParity(*this->Shown);
}

// Where scalars are transparent nothing is shaded: with scalars of points and of cells.
TEST_F(LightParity, TransparentRanges)
{
  setTwoPeaks(this->Shown->property());
  this->addSun();
  this->Shown->Mapper->SetShadowMethodToAtVertices();
  this->Shown->Mapper->SetVolumetricScatteringBlending(1.0f);
  expectParity(*this->Shown);
  this->Shown->drawCellScalars();
  expectParity(*this->Shown);
}

TEST_F(LightParity, OneColour)
{
  this->addSun();
  vtkColorTransferFunction* color = this->Shown->property()->GetRGBTransferFunction();
  color->RemoveAllPoints();
  color->AddRGBPoint(0.0, 0.9, 0.5, 0.1);
  this->Shown->Mapper->SetShadowMethodToAtVertices();
  expectParity(*this->Shown);
}

TEST_F(LightParity, ShadowsOfTheSun)
{
  this->addSun();
  this->Shown->Mapper->SetShadowMethodToAtVertices();
  expectParity(*this->Shown);
}

TEST_F(LightParity, ShadowsOfThreeLightsAndThroughGradientOpacity)
{
  Scene& scene = *this->Shown;
  setGradientOpacity(scene.property());
  this->addSun();
  addLightsThatCastShadows(scene.Renderer);
  scene.Mapper->SetShadowMethodToAtVertices();
  expectParity(scene);
}

TEST_F(LightParity, ShadowsOfTheHeadlight)
{
  this->Shown->Mapper->SetShadowMethodToAutomatic();
  expectParity(*this->Shown);
}

TEST_F(LightParity, ShortReach)
{
  this->addSun();
  this->Shown->Mapper->SetShadowMethodToAtVertices();
  this->Shown->Mapper->SetGlobalIlluminationReach(0.3f);
  expectParity(*this->Shown);
}

TEST_F(LightParity, ShadowsInAMeshWithATunnel)
{
  this->use(latticeWithTunnel(9, 0.15, 1, sineField()));
  this->Shown->camera()->SetPosition(0.9, 0.8, 3.2);
  this->addSun();
  this->Shown->Mapper->SetShadowMethodToAtVertices();
  this->Shown->Mapper->AmbientOcclusionOn();
  expectParity(*this->Shown);
}

TEST_F(LightParity, AmbientOcclusion)
{
  this->Shown->property()->SetAmbient(0.8);
  this->Shown->Mapper->AmbientOcclusionOn();
  this->Shown->Mapper->SetAmbientOcclusionRadius(0.3);
  expectParity(*this->Shown);
}

TEST_F(LightParity, Scattering)
{
  this->addSun();
  for (const float blending : { 0.5f, 1.0f, 1.5f, 2.0f })
  {
    this->Shown->Mapper->SetVolumetricScatteringBlending(blending);
    expectParity(*this->Shown);
  }
}

TEST_F(LightParity, ScatteringOfTheHeadlight)
{
  this->Shown->Mapper->SetVolumetricScatteringBlending(1.5f);
  expectParity(*this->Shown);
}

TEST_F(LightParity, OpaqueGeometryInside)
{
  this->Shown->Renderer->AddActor(makeBall({ 0.5, 0.5, 0.6 }, 0.25, { 1.0, 1.0, 1.0 }));
  this->addSun();
  this->Shown->Mapper->SetShadowMethodToAtVertices();
  expectParityWithOpaque(*this->Shown);
}

TEST_F(LightParity, CameraInside)
{
  this->Shown->camera()->SetPosition(0.5, 0.45, 0.55);
  this->Shown->camera()->SetFocalPoint(0.9, 0.8, 0.2);
  this->Shown->camera()->SetClippingRange(0.01, 4.0);
  this->addSun();
  this->Shown->Mapper->SetShadowMethodToAtVertices();
  this->Shown->Mapper->AmbientOcclusionOn();
  expectParity(*this->Shown);
}
} // namespace
