// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of a volume of each kind with each effect of light, pixel by pixel against the
// CPU reference.
#include "Lights.h"
#include "ParityScenes.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

// A headlight, which is what there is if nobody has set a light, shines in another direction.
template <typename Kind>
void addSun(Kind& scene)
{
  addLight(scene.Renderer, 3.0, 4.0, 1.5);
}

// Light is computed in the frame of the world then.
template <typename Kind>
void stretchAndTurn(Kind& scene)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(0.1, 0.05, 0.0);
  transform->RotateWXYZ(30.0, 1.0, 2.0, 3.0);
  transform->Scale(1.0, 0.5, 0.8);
  scene.Volume->SetUserTransform(transform);
  addPointLight(scene.Renderer, -0.2, 1.4, 0.9);
}

template <typename Kind>
void setOneColour(Kind& scene)
{
  vtkColorTransferFunction* color = scene.property()->GetRGBTransferFunction();
  color->RemoveAllPoints();
  color->AddRGBPoint(0.0, 0.9, 0.5, 0.1);
}

template <typename Kind>
const Case<Kind> Settings[] = {
  { "dim coloured headlight in parallel projection",
    [](Kind& scene)
    {
      addDimColouredHeadlight(scene.Renderer);
      scene.camera()->ParallelProjectionOn();
      scene.camera()->SetParallelScale(0.9);
    } },
  { "lights of all kinds",
    [](Kind& scene)
    {
      addSun(scene);
      addFadingLight(scene.Renderer);
      addSpotlight(scene.Renderer);
      addCameraLight(scene.Renderer);
      addFillLight(scene.Renderer);
      addLight(scene.Renderer, 0.0, 9.0, 0.0)->SwitchOff();
    } },
  { "stretched and turned", stretchAndTurn<Kind> },
  // Nothing is shaded there.
  { "transparent ranges, then opaque geometry",
    [](Kind& scene)
    {
      addSun(scene);
      scene.setTransparentRanges();
      scene.expectParity("transparent ranges");
      scene.Renderer->AddActor(makeBall({ 0.5, 0.5, 0.6 }, 0.25, { 1.0, 1.0, 1.0 }));
    } },
  { "one colour",
    [](Kind& scene)
    {
      addSun(scene);
      setOneColour(scene);
    } },
  { "camera inside",
    [](Kind& scene)
    {
      addSun(scene);
      lookFromInside(scene.camera());
    } },
  // These need no rays towards the light.
  { "preset of the headlight",
    [](Kind& scene)
    {
      addSun(scene);
      scene.Mapper->SetLightPresetToHeadlight();
    } },
  { "shadows of the headlight", [](Kind& scene) { scene.Mapper->SetShadowMethodToAutomatic(); } },
  { "scattering of the headlight",
    [](Kind& scene) { scene.Mapper->SetVolumetricScatteringBlending(1.5f); } },
};

// Light that has come through the volume is kept at vertices.
const Case<MeshParity> AtVertices[] = {
  { "the sun", [](MeshParity&) {} },
  { "stretched and turned", stretchAndTurn<MeshParity> },
  { "transparent ranges, with scattering",
    [](MeshParity& scene)
    {
      setTwoPeaks(scene.property());
      scene.Mapper->SetVolumetricScatteringBlending(1.0f);
      scene.expectParity("points");
      scene.drawConstantCells();
    } },
  { "one colour", setOneColour<MeshParity> },
  { "three lights, through gradient opacity",
    [](MeshParity& scene)
    {
      setGradientOpacity(scene.property());
      addLightsThatCastShadows(scene.Renderer);
    } },
  { "short reach", [](MeshParity& scene) { scene.Mapper->SetGlobalIlluminationReach(0.3f); } },
  { "ambient occlusion",
    [](MeshParity& scene)
    {
      scene.property()->SetAmbient(0.8);
      scene.Mapper->AmbientOcclusionOn();
      scene.Mapper->SetAmbientOcclusionRadius(0.3);
      scene.Mapper->SetShadowMethodToOff();
    } },
  { "presets of the studio and of the sun, in place of lights and property",
    [](MeshParity& scene)
    {
      scene.property()->ShadeOff();
      scene.Mapper->SetShadowMethodToOff();
      scene.Mapper->SetLightPresetToStudio();
      scene.expectParity("studio");
      scene.Mapper->SetLightPresetToSun();
    } },
  { "scattering",
    [](MeshParity& scene)
    {
      scene.Mapper->SetShadowMethodToOff();
      for (const float blending : { 0.5f, 1.0f, 1.5f })
      {
        scene.Mapper->SetVolumetricScatteringBlending(blending);
        scene.expectParity("scattering " + std::to_string(blending));
      }
      scene.Mapper->SetVolumetricScatteringBlending(2.0f);
    } },
  { "opaque geometry",
    [](MeshParity& scene) {
      scene.Renderer->AddActor(makeBall({ 0.5, 0.5, 0.6 }, 0.25, { 1.0, 1.0, 1.0 }));
    } },
  { "camera inside",
    [](MeshParity& scene)
    {
      scene.camera()->SetPosition(0.5, 0.45, 0.55);
      scene.camera()->SetFocalPoint(0.9, 0.8, 0.2);
      scene.camera()->SetClippingRange(0.01, 4.0);
      scene.Mapper->AmbientOcclusionOn();
    } },
};

template <typename Kind>
class LightParity : public testing::Test
{
};
TYPED_TEST_SUITE(LightParity, ParityKinds, ParityKindNames);

TYPED_TEST(LightParity, EachKindOfScalars)
{
  TypeParam::forEachScalars(
    [](TypeParam& scene, const std::string& name)
    {
      setShading(scene.property());
      scene.expectParity(name + ", headlight");
      scene.Renderer->TwoSidedLightingOff();
      addSun(scene);
      scene.expectParity(name + ", the sun on one side");
      scene.Mapper->SetGradientTypeToCell();
      scene.expectParity(name + ", gradients of cells");
      setGradientOpacity(scene.property());
      scene.expectParity(name + ", gradient opacity of cells");
      scene.Mapper->SetGradientTypeToVertex();
      scene.expectParity(name + ", gradient opacity");
      scene.property()->ShadeOff();
      scene.expectParity(name + ", gradient opacity unlit");
    });
}

// Cells that show nothing are passed without a shade. The next one has its own then, which is that
// of a medium so thin that it shows as little.
TYPED_TEST(LightParity, BehindTransparentCells)
{
  TypeParam::forEachScalars(
    [](TypeParam& scene, const std::string& name)
    {
      setShading(scene.property());
      scene.Mapper->SetAccuracyLevelToAccurate();
      for (const bool scatters : { true, false })
      {
        scene.Mapper->SetVolumetricScatteringBlending(scatters ? 1.0f : 0.0f); // of the headlight
        if (!scatters)
        {
          addSun(scene);
        }
        Image pictures[2];
        for (const double least : { 0.0, 1e-5 })
        {
          vtkPiecewiseFunction* opacity = scene.property()->GetScalarOpacity();
          opacity->RemoveAllPoints();
          opacity->AddPoint(0.6, least);
          opacity->AddPoint(0.7, 0.9);
          opacity->AddPoint(0.8, least);
          scene.expectParity(
            name + (least > 0.0 ? ", thin around a peak" : ", nothing around a peak"));
          pictures[least > 0.0] = scene.frame();
        }
        // Cells are cut otherwise then, and light is outside of the tolerance.
        EXPECT_LE(compare(pictures[0], pictures[1]).Max, 3.0 / 255.0) << name << ", " << scatters;
      }
    });
}

TYPED_TEST(LightParity, EachSetting)
{
  TypeParam plain;
  setShading(plain.property());
  const Image headlight = plain.render();
  for (const Case<TypeParam>& setting : Settings<TypeParam>)
  {
    TypeParam scene;
    setShading(scene.property());
    setting.Change(scene);
    scene.expectParity(setting.Name);
    EXPECT_GT(compare(scene.render(), headlight).Max, 0.02) << setting.Name << " changes nothing";
  }
}

TEST(MeshLight, AtVertices)
{
  for (const Case<MeshParity>& effect : AtVertices)
  {
    MeshParity scene;
    setShading(scene.property());
    addSun(scene);
    scene.Mapper->SetShadowMethodToAtVertices();
    effect.Change(scene);
    scene.expectParity(std::string("at vertices, ") + effect.Name);
  }
}

TEST(MeshLight, ShadowsInAMeshWithATunnel)
{
  Scene scene(latticeWithTunnel(9, 0.15, 1, sineField()), 80, 80);
  setShading(scene.property());
  scene.camera()->SetPosition(0.9, 0.8, 3.2);
  addSun(scene);
  scene.Mapper->SetShadowMethodToAtVertices();
  scene.Mapper->AmbientOcclusionOn();
  expectParity(scene);
}

// A volume that is hardly stretched looks like one that isn't, though its light is computed in the
// frame of the world.
TEST(MeshLight, LightInTheWorldIsThatInTheMesh)
{
  MeshParity scene;
  setShading(scene.property());
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
      addSun(scene);
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
      scene.expectParity("turned");
      pictures[stretched] = scene.frame();
    }
    const Difference difference = compare(pictures[0], pictures[1]);
    std::printf("%s\n", difference.text().c_str());
    EXPECT_LE(difference.Rms, 0.3 / 255.0);
  }
}
} // namespace
