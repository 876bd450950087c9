// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures of volumes in the shadow of opaque geometry: the GL's against the CPU reference's, and
// either against light computed by brute force.
#include "CpuReference.h"
#include "Lights.h"
#include "LitScene.h"
#include "ScenePage.h"
#include "StructuredScene.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;
using tetmarch::LightAt;

// A square between the volume and the sun, out of the camera's sight.
vtkSmartPointer<vtkActor> makeSunshade(double side)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.5 * side, -0.5 * side, 0.0);
  plane->SetPoint1(0.5 * side, -0.5 * side, 0.0);
  plane->SetPoint2(-0.5 * side, 0.5 * side, 0.0);
  plane->SetNormal(2.5, 3.5, 1.0);
  plane->SetCenter(2.0, 2.6, 1.1);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

class OpaqueShadowPicture : public testing::Test
{
protected:
  void use(vtkUnstructuredGrid* grid, int side = SceneSize)
  {
    this->Shown = std::make_unique<LitScene>(grid, side, side);
    this->Shown->Mapper->SetShadowMethodToAtVertices();
    this->Shown->Mapper->OpaqueShadowsOn();
  }
  OpaqueShadowPicture() { this->use(jitteredLattice(10, 0.15, 1, sineField())); }

  // They change the picture, and are those of the reference.
  void expectShadows()
  {
    const Image with = this->Shown->render();
    this->Shown->Mapper->OpaqueShadowsOff();
    EXPECT_GT(compare(this->Shown->render(), with).Max, 0.03);
    this->Shown->Mapper->OpaqueShadowsOn();
    expectParityWithOpaque(*this->Shown);
  }

  void shade() { this->Shown->Renderer->AddActor(makeSunshade(0.6)); }

  std::unique_ptr<LitScene> Shown;
};

TEST_F(OpaqueShadowPicture, OfAPlate)
{
  this->shade();
  this->expectShadows();
}

TEST_F(OpaqueShadowPicture, OfABallInside)
{
  this->Shown->Renderer->AddActor(makeBall({ 0.5, 0.5, 0.6 }, 0.25, { 1.0, 1.0, 1.0 }));
  this->expectShadows();
}

TEST_F(OpaqueShadowPicture, OfThreeLightsAndThroughGradientOpacity)
{
  this->shade();
  this->Shown->addGradientOpacity();
  vtkNew<vtkLight> source;
  source->SetLightTypeToSceneLight();
  source->PositionalOn();
  source->SetConeAngle(180.0);
  source->SetPosition(2.5, 3.0, 1.6);
  source->SetDiffuseColor(1.0, 0.5, 0.1);
  this->Shown->Renderer->AddLight(source);
  vtkNew<vtkLight> weak;
  weak->SetLightTypeToSceneLight();
  weak->SetPosition(-2.0, 1.0, 0.0);
  weak->SetShadowAttenuation(0.4f);
  this->Shown->Renderer->AddLight(weak);
  this->Shown->Renderer->AddActor(makeBall({ -0.4, 0.6, 0.4 }, 0.3, { 1.0, 1.0, 1.0 }));
  this->expectShadows();
}

TEST_F(OpaqueShadowPicture, OnAStretchedAndTurnedVolume)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(0.1, 0.05, 0.0);
  transform->RotateWXYZ(30.0, 1.0, 2.0, 3.0);
  transform->Scale(1.0, 0.5, 0.8);
  this->Shown->Volume->SetUserTransform(transform);
  this->shade();
  this->expectShadows();
}

TEST_F(OpaqueShadowPicture, OfCellScalars)
{
  this->use(jitteredLattice(8, 0.15, 1, sineField()));
  this->Shown->drawCellScalars();
  this->shade();
  this->expectShadows();
}

TEST_F(OpaqueShadowPicture, WithOcclusionScatteringAndGradientsOfCells)
{
  this->shade();
  this->Shown->Mapper->AmbientOcclusionOn();
  this->Shown->Mapper->SetGradientTypeToCell();
  this->Shown->Mapper->SetShadowMethodToOff();
  this->Shown->Mapper->SetVolumetricScatteringBlending(1.5f);
  this->expectShadows();
}

TEST_F(OpaqueShadowPicture, ThroughATunnelAndAtTheFastLevel)
{
  this->use(latticeWithTunnel(9, 0.15, 1, sineField()));
  this->shade();
  this->Shown->Mapper->SetAccuracyLevelToFast();
  this->expectShadows();
}

// Samples along rays search the surfaces themselves: a tolerance of light is kept, in dense cells,
// in a bright light and in thin air.
TEST_F(OpaqueShadowPicture, KeepATolerance)
{
  struct Scenery
  {
    double UnitDistance;
    double Intensity;
    double Kept; // tolerances: in a bright light steps are shorter, but more of them add up
  };
  constexpr double tolerance = 2.0 / 255.0;
  this->use(jitteredLattice(10, 0.15, 1, sineField()), 80);
  this->shade();
  this->Shown->Renderer->AddActor(makeBall({ 0.5, 0.5, 0.6 }, 0.25, { 1.0, 1.0, 1.0 }));
  vtkNew<vtkLight> source;
  source->SetLightTypeToSceneLight();
  source->PositionalOn();
  source->SetConeAngle(180.0);
  source->SetPosition(0.9, 0.5, 0.9);
  source->SetDiffuseColor(0.3, 0.15, 0.03);
  this->Shown->Renderer->AddLight(source);
  this->Shown->property()->SetSpecular(0.0);
  for (const auto& [unitDistance, intensity, kept] :
    { Scenery{ 0.02, 1.0, 1.0 }, Scenery{ 1.0, 4.0, 2.0 }, Scenery{ 5.0, 1.0, 1.0 } })
  {
    this->Shown->property()->SetScalarOpacityUnitDistance(unitDistance);
    this->Shown->Sun->SetIntensity(intensity);
    this->Shown->Mapper->SetLightTolerance(0.0);
    this->Shown->render();
    const Mask inside = regionsOf(*this->Shown).Inside;
    const Image exact =
      referenceOf(*this->Shown, this->Shown->windowDepths(), Precision::Double, LightAt::Points)
        .Picture;
    this->Shown->Mapper->SetLightTolerance(tolerance);
    const Difference difference = compare(this->Shown->render(), exact, inside, kept * tolerance);
    std::cout << "[ MEASURED ] " << unitDistance << ": " << difference.text() << '\n';
    EXPECT_LE(1000 * difference.Over, difference.Pixels);
    this->Shown->Mapper->OpaqueShadowsOff();
    EXPECT_GT(compare(this->Shown->render(), exact, inside).Rms, 4.0 * difference.Rms);
    this->Shown->Mapper->OpaqueShadowsOn();
  }
}

TEST_F(OpaqueShadowPicture, KeepAToleranceInAnImage)
{
  constexpr double tolerance = 2.0 / 255.0;
  StructuredScene scene(imageOf(sineField(), unitCube(16)), 64, 64);
  addLight(scene.Renderer, 2.5, 3.5, 1.0);
  scene.Renderer->AddActor(makeSunshade(0.6));
  scene.property()->ShadeOn();
  scene.property()->SetScalarOpacityUnitDistance(0.25);
  scene.Mapper->SetVolumetricScatteringBlending(2.0f);
  scene.Mapper->OpaqueShadowsOn();
  scene.Mapper->SetLightTolerance(tolerance);
  const Image drawn = scene.render();
  keepScenePage(scene.Window);
  const Difference difference = compare(drawn, scene.drawnWith(LightAt::Points), {}, tolerance);
  std::cout << "[ MEASURED ] " << difference.text() << '\n';
  EXPECT_LE(1000 * difference.Over, difference.Pixels);
  scene.Mapper->OpaqueShadowsOff();
  EXPECT_GT(compare(scene.render(), drawn).Rms, 4.0 / 255.0);
}

// A light's shadow strength says which share of it an obstacle takes away.
TEST_F(OpaqueShadowPicture, AsStrongAsTheLightSays)
{
  Scene& scene = *this->Shown;
  scene.Renderer->AddActor(makeSunshade(9.0)); // all of it
  scene.Mapper->SetViewModeToIllumination();
  scene.property()->SetAmbient(0.0);
  scene.property()->SetSpecular(0.0);
  this->Shown->Sun->SetShadowAttenuation(0.25f);
  scene.Mapper->SetShadowMethodToAlongRays();
  const Image shadowed = scene.render();
  scene.Mapper->SetShadowMethodToOff();
  const Image lit = scene.render();
  double most = 0.0;
  for (std::size_t i = 0; i < lit.Rgba.size(); ++i)
  {
    const double share = i % 4 == 3 ? 1.0 : 0.75;
    EXPECT_NEAR(double(shadowed.Rgba[i]), share * double(lit.Rgba[i]), 2.0 / 255.0);
    most = std::max(most, double(lit.Rgba[i]) * (1.0 - share));
  }
  EXPECT_GT(most, 0.1);
}

// Headlights cast no shadow that the camera could see.
TEST_F(OpaqueShadowPicture, HeadlightsCastNone)
{
  this->shade();
  this->Shown->Sun->SetLightTypeToHeadlight();
  const Image with = this->Shown->render();
  EXPECT_EQ(this->Shown->Mapper->GetOpaqueShadowsBuilds(), 0);
  this->Shown->Mapper->OpaqueShadowsOff();
  EXPECT_EQ(this->Shown->render().Rgba, with.Rgba);
}

// In a thin medium, whose own shadows are soft: at vertices, the edges of those of a plate are as
// wide as cells.
TEST(OpaqueShadowError, OfAPlateOnAThinMedium)
{
  for (const int cubes : { 12, 24 })
  {
    LitScene scene(jitteredLattice(cubes, 0.15, 1, sineField()), 96, 96);
    scene.property()->SetScalarOpacityUnitDistance(1.0);
    scene.Sun->SetIntensity(3.0);
    scene.Renderer->AddActor(makeSunshade(0.6));
    scene.Mapper->OpaqueShadowsOn();
    scene.Mapper->SetShadowMethodToAtVertices();
    const Image atVertices = scene.render();
    const Image exact =
      referenceOf(scene, scene.windowDepths(), Precision::Double, LightAt::Points).Picture;
    const Mask inside = regionsOf(scene).Inside;
    scene.Mapper->SetShadowMethodToAlongRays();
    const Image alongRays = scene.render();
    // The ground truth has the shadow: without ours the error is far greater.
    scene.Mapper->OpaqueShadowsOff();
    const Image without = scene.render();
    EXPECT_GT(compare(without, exact, inside).Rms, 16.0 / 255.0);
    for (const auto& [name, drawn] :
      { std::pair("at vertices", &atVertices), std::pair("along rays", &alongRays) })
    {
      const Difference difference = compare(*drawn, exact, inside);
      std::cout << "[ MEASURED ] " << cubes << " cubes a side, " << name << ": "
                << difference.text() << '\n';
      EXPECT_LE(difference.Rms, 4.0 / 255.0);
    }
  }
}

TEST(OpaqueShadowError, TheMappersReferenceHasThem)
{
  LitScene scene(jitteredLattice(8, 0.15, 1, sineField()), 64, 64);
  scene.Renderer->AddActor(makeSunshade(0.6));
  scene.Mapper->OpaqueShadowsOn();
  scene.Mapper->SetShadowMethodToAtVertices();
  scene.Mapper->SetAccuracyLevelToReference();
  scene.render();
  const Image exact =
    referenceOf(scene, scene.windowDepths(), Precision::Double, LightAt::Points).Picture;
  vtkNew<vtkFloatArray> pixels;
  ASSERT_TRUE(scene.Mapper->RenderGroundTruth(scene.Volume, pixels));
  const Image reference = Image::fromFloats(64, 64, pixels->GetPointer(0));
  EXPECT_LE(compare(reference, exact, regionsOf(scene).Inside).Max, 2.0 / 255.0);
}
} // namespace
