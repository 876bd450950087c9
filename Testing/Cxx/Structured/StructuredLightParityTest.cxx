// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of structured volumes with each effect of light, pixel by pixel against the CPU
// reference.
#include "Lights.h"
#include "StructuredScene.h"

#include "vtkActor.h"
#include "vtkDataSetAttributes.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr Promises Lit{ true, false };

class StructuredLight : public testing::Test
{
protected:
  StructuredLight() { setShading(this->Shown.property()); }
  void addSun() { this->Shown.addLight(3.0, 4.0, 1.5); }

  StructuredScene Shown{ imageOf(sineField(), unitCube(8)) };
};

TEST_F(StructuredLight, Headlight)
{
  expectParityOf(AllLatticeValues, this->Shown, "headlight", Lit);
  this->Shown.Mapper->SetGradientTypeToCell();
  report("headlight, cell gradients", expectParity(this->Shown, Lit));
}

TEST_F(StructuredLight, DimColouredHeadlight)
{
  addDimColouredHeadlight(this->Shown.Renderer);
  this->Shown.camera()->ParallelProjectionOn();
  this->Shown.camera()->SetParallelScale(0.9);
  report("coloured headlight", expectParity(this->Shown, Lit));
}

TEST_F(StructuredLight, OneSideAndBothGradients)
{
  this->addSun();
  this->Shown.Renderer->TwoSidedLightingOff();
  for (const LatticeValues values : { LatticeValues::PointsLinear, LatticeValues::CellsLinear })
  {
    this->Shown.draw(values);
    this->Shown.Mapper->SetGradientTypeToVertex();
    report(std::string("sun, ") + nameOf(values), expectParity(this->Shown, Lit));
    this->Shown.Mapper->SetGradientTypeToCell();
    report(std::string("sun, cell gradients, ") + nameOf(values), expectParity(this->Shown, Lit));
  }
}

TEST_F(StructuredLight, LightsOfAllKinds)
{
  this->addSun();
  addFadingLight(this->Shown.Renderer);
  addSpotlight(this->Shown.Renderer);
  addCameraLight(this->Shown.Renderer);
  report("lights of all kinds", expectParity(this->Shown, Lit));
}

// Light is computed in the frame of the world then.
TEST_F(StructuredLight, StretchedAndTurnedVolume)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(0.1, 0.05, 0.0);
  transform->RotateWXYZ(30.0, 1.0, 2.0, 3.0);
  transform->Scale(1.0, 0.5, 0.8);
  this->Shown.Volume->SetUserTransform(transform);
  addPointLight(this->Shown.Renderer, -0.2, 1.4, 0.9);
  report("stretched", expectParity(this->Shown, Lit));
}

// Gradients of an image that its own directions turn.
TEST_F(StructuredLight, ImagesInAllPlaces)
{
  for (const ImagePlace& place : imagePlaces())
  {
    SCOPED_TRACE(place.Name);
    StructuredScene scene(imageOf(sineField(), place), 20, 20);
    setShading(scene.property());
    scene.lookAtAll();
    report(place.Name + ", lit", expectParity(scene, Lit));
  }
}

TEST_F(StructuredLight, GradientOpacity)
{
  setGradientOpacity(this->Shown.property());
  for (const bool shaded : { true, false })
  {
    this->Shown.property()->SetShade(shaded);
    // The bound knows of gradients by the light that they reflect.
    expectParityOf(AllLatticeValues, this->Shown,
      shaded ? "gradient opacity" : "gradient opacity unlit", { shaded, false });
  }
  this->Shown.draw(LatticeValues::PointsLinear);
  this->Shown.Mapper->SetGradientTypeToCell();
  report("gradient opacity of cells", expectParity(this->Shown, { false, false }));
}

TEST_F(StructuredLight, TransparentRangesOneColourAndOpaqueGeometry)
{
  this->addSun();
  setTwoPeaks(this->Shown.property());
  report("two peaks", expectParity(this->Shown, Lit));
  this->Shown.Renderer->AddActor(makeBall({ 0.5, 0.5, 0.6 }, 0.25, { 1.0, 1.0, 1.0 }));
  report("two peaks, opaque geometry", expectParity(this->Shown, Lit));
  vtkColorTransferFunction* color = this->Shown.property()->GetRGBTransferFunction();
  color->RemoveAllPoints();
  color->AddRGBPoint(0.0, 0.9, 0.5, 0.1);
  report("one colour", expectParity(this->Shown, Lit));
  lookFromInside(this->Shown.camera());
  report("camera inside", expectParity(this->Shown, Lit));
}

TEST_F(StructuredLight, RectilinearWithHiddenCells)
{
  const auto grid = rectilinearOf(sineField(), unevenCube(7));
  markCells(grid, vtkDataSetAttributes::HIDDENCELL, [](vtkIdType id) { return id % 13 == 3; });
  StructuredScene scene(grid);
  setShading(scene.property());
  scene.addLight(3.0, 4.0, 1.5);
  expectParityOf(AllLatticeValues, scene, "rectilinear, lit", Lit);
}

// These need no rays towards the light.
TEST_F(StructuredLight, ShadowsOfTheHeadlight)
{
  const Image without = this->Shown.render();
  this->Shown.Mapper->SetShadowMethodToAutomatic();
  report("shadows of the headlight", expectParity(this->Shown, Lit));
  EXPECT_GT(compare(without, this->Shown.pixels()).Max, 0.02);
  this->Shown.Mapper->SetVolumetricScatteringBlending(1.5f);
  report("scattering of the headlight", expectParity(this->Shown, Lit));
}

TEST_F(StructuredLight, ShadowsAlongRays)
{
  this->addSun();
  this->Shown.property()->SetScalarOpacityUnitDistance(0.5);
  expectShadowsAlongRays(
    { LatticeValues::PointsLinear, LatticeValues::PointsNearest, LatticeValues::CellsLinear },
    this->Shown);
}

TEST_F(StructuredLight, ShadowsOfThreeLightsThroughGradientOpacity)
{
  setGradientOpacity(this->Shown.property());
  this->addSun();
  addLightsThatCastShadows(this->Shown.Renderer);
  this->Shown.Mapper->SetShadowMethodToAlongRays();
  expectLightAlongRays(this->Shown, "three lights");
  this->Shown.Mapper->SetGlobalIlluminationReach(0.3f);
  expectLightAlongRays(this->Shown, "three lights, short reach");
}

TEST_F(StructuredLight, Scattering)
{
  this->addSun();
  this->Shown.property()->SetScalarOpacityUnitDistance(0.5);
  this->Shown.Mapper->SetShadowMethodToAlongRays();
  for (const float blending : { 0.5f, 1.0f, 1.5f, 2.0f })
  {
    this->Shown.Mapper->SetVolumetricScatteringBlending(blending);
    expectLightAlongRays(this->Shown, "scattering " + std::to_string(blending));
  }
}
} // namespace
