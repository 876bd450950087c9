// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the GL draws of dependent components of a volume of each kind in light, pixel by pixel
// against the CPU reference; and that the light is that of the component which gives the opacity.
#include "Lights.h"
#include "OwnGradients.h"
#include "ParityScenes.h"

#include "vtkActor.h"
#include "vtkLight.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

Grid lattice(int cubes = 10) { return jitteredLattice(cubes, 0.15, 1, sineField()); }

// Shaded by all of the property's numbers; the light is a headlight unless there is a sun.
class LitComponentScene : public ComponentScene
{
public:
  explicit LitComponentScene(const Mix& mix, int cubes = 10, int side = 80)
    : ComponentScene(lattice(cubes), mix, side, side)
  {
    setShading(this->property());
  }
  void addSun() { this->Sun = addLight(*this, 3.0, 4.0, 1.5); }

  vtkSmartPointer<vtkLight> Sun;
};

constexpr double MostRms = 0.3 / 255.0;
constexpr Mix Dependent[] = { Mixes[3], Mixes[4] };

template <typename Kind>
const Case<Kind> Effects[] = {
  { "lights of all kinds before opaque geometry",
    [](Kind& scene)
    {
      addLight(scene.Renderer, 3.0, 4.0, 1.5);
      addFadingLight(scene.Renderer);
      addFillLight(scene.Renderer);
      scene.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 1.0, 1.0 }));
    } },
  { "gradients of cells",
    [](Kind& scene)
    {
      addLight(scene.Renderer, 3.0, 4.0, 1.5);
      scene.Mapper->SetGradientTypeToCell();
    } },
  { "gradient opacity", [](Kind& scene) { setGradientOpacity(scene.property()); } },
  { "gradient opacity unlit",
    [](Kind& scene)
    {
      setGradientOpacity(scene.property());
      scene.property()->ShadeOff();
    } },
  { "gradient opacity of constant cells, unlit",
    [](Kind& scene)
    {
      setGradientOpacity(scene.property());
      scene.drawConstantCells();
      scene.property()->ShadeOff();
    } },
  { "constant cells", [](Kind& scene) { scene.drawConstantCells(); } },
  { "shadows of the headlight", [](Kind& scene) { scene.Mapper->SetShadowMethodToAutomatic(); } },
};

template <typename Kind>
class LitComponentParity : public ::testing::Test
{
};
TYPED_TEST_SUITE(LitComponentParity, ParityKinds, ParityKindNames);

TYPED_TEST(LitComponentParity, EachEffect)
{
  for (const Mix& mix : Dependent)
  {
    const auto prepare = [&](TypeParam& scene)
    {
      drawMix(scene, mix);
      setShading(scene.property());
    };
    TypeParam plain;
    prepare(plain);
    plain.expectParity(mix.Name + std::string(", headlight"));
    const Image without = plain.render();
    for (const Case<TypeParam>& effect : Effects<TypeParam>)
    {
      TypeParam scene;
      prepare(scene);
      effect.Change(scene);
      scene.expectParity(std::string(mix.Name) + ", " + effect.Name);
      EXPECT_GT(compare(scene.render(), without).Max, 0.02) << effect.Name << " is not seen";
    }
  }
}

class LitMeshComponents : public ::testing::TestWithParam<Mix>
{
};

struct ThroughVolume
{
  const char* Name;
  void (*Add)(LitComponentScene& scene);
};

const ThroughVolume ThroughVolumes[] = {
  { "shadows of the sun", [](LitComponentScene& s) { s.Mapper->SetShadowMethodToAtVertices(); } },
  { "shadows of a headlight",
    [](LitComponentScene& s)
    {
      s.Sun->SetLightTypeToHeadlight();
      s.Mapper->SetShadowMethodToAutomatic();
    } },
  { "ambient occlusion",
    [](LitComponentScene& s)
    {
      s.property()->SetAmbient(0.8);
      s.Mapper->AmbientOcclusionOn();
      s.Mapper->SetAmbientOcclusionRadius(0.3);
    } },
  { "scattering", [](LitComponentScene& s) { s.Mapper->SetVolumetricScatteringBlending(1.3f); } },
  { "shadows of the sun and of opaque geometry, through gradient opacity, with scattering",
    [](LitComponentScene& s)
    {
      setGradientOpacity(s.property());
      s.Renderer->AddActor(makeBall({ 2.0, 2.6, 1.1 }, 0.35, { 1.0, 1.0, 1.0 }));
      s.Mapper->SetShadowMethodToAtVertices();
      s.Mapper->OpaqueShadowsOn();
      s.Mapper->SetVolumetricScatteringBlending(1.3f);
    } },
};

TEST_P(LitMeshComponents, TransparentRanges)
{
  for (const bool cells : { false, true })
  {
    LitComponentScene scene(GetParam());
    vtkPiecewiseFunction* opacity = scene.property()->GetScalarOpacity();
    opacity->RemoveAllPoints();
    opacity->AddPoint(0.6, 0.0);
    opacity->AddPoint(0.7, 0.9);
    opacity->AddPoint(0.8, 0.0);
    if (cells)
    {
      scene.drawCells();
    }
    scene.addSun();
    expectParity(scene);
  }
}

TEST_P(LitMeshComponents, LightThroughTheVolume)
{
  for (const ThroughVolume& effect : ThroughVolumes)
  {
    for (const bool cells : { false, true })
    {
      SCOPED_TRACE(std::string(effect.Name) + (cells ? ", cells" : ", points"));
      LitComponentScene scene(GetParam());
      if (cells)
      {
        scene.drawCells();
      }
      scene.addSun();
      const Image without = scene.render();
      effect.Add(scene);
      expectParityWithOpaque(scene);
      EXPECT_GT(compare(scene.render(), without).Max, 0.02) << "the effect isn't there";
    }
  }
}

// Light that is sampled at random points of rays, against light computed in all places.
TEST_P(LitMeshComponents, ShadowsAlongRays)
{
  for (const bool cells : { false, true })
  {
    LitComponentScene scene(GetParam(), 5, 64);
    if (cells)
    {
      scene.drawCells();
    }
    scene.addSun();
    const Image without = scene.render();
    scene.Mapper->SetShadowMethodToAlongRays();
    const Image drawn = scene.render();
    expectLightAlongRays(scene, drawn, without);
  }
}

// The views of the light know no colours: they are the same when the component of the opacity is
// drawn alone.
TEST_P(LitMeshComponents, LightIsThatOfTheOpacity)
{
  for (const bool cells : { false, true })
  {
    LitComponentScene scene(GetParam());
    // Segments are the same then whatever their colours.
    scene.Mapper->SetAccuracyLevelToFast();
    if (cells)
    {
      scene.drawCells();
    }
    scene.addSun();
    for (const int view : { Mapper::VIEW_ILLUMINATION, Mapper::VIEW_GRADIENTS })
    {
      scene.Mapper->SetViewMode(view);
      scene.property()->IndependentComponentsOff();
      scene.Mapper->SetVectorModeToDisabled();
      const Image together = scene.render();
      scene.Mapper->SetVectorModeToComponent();
      const int last = GetParam().Components - 1;
      scene.Mapper->SetVectorComponent(last);
      const Image alone = scene.render();
      scene.Mapper->SetVectorComponent(0);
      const Difference difference = compare(together, alone);
      std::cout << "[ MEASURED ] " << difference.text() << '\n';
      EXPECT_LE(difference.Max, 2.0 / 255.0) << difference.text();
      EXPECT_LE(difference.Rms, MostRms) << difference.text();
      EXPECT_GT(compare(together, scene.render()).Rms, 10.0 / 255.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, LitMeshComponents, ::testing::ValuesIn(Dependent),
  [](const auto& of) { return of.param.Name; });

class LitIndependentMeshComponents : public ::testing::TestWithParam<Mix>
{
};

TEST_P(LitIndependentMeshComponents, EachIsLitByItsOwnGradient)
{
  const Mix& mix = GetParam();
  const Grid grid = withComponents(lattice(6), linearComponents(mix.Components), VTK_DOUBLE);
  Scene lit(grid), dimmed(grid);
  drawComponents(lit, mix);
  drawComponents(dimmed, mix);
  expectLightOfOwnGradients(lit, dimmed, mix.Components);
}

TEST_P(LitIndependentMeshComponents, ByLightsOfAllKinds)
{
  for (const bool cells : { false, true })
  {
    SCOPED_TRACE(cells ? "cells" : "points");
    ComponentScene scene(lattice(8), GetParam(), 64, 64);
    if (cells)
    {
      scene.drawCells();
    }
    const Image unlit = scene.render();
    setShading(scene.property());
    expectParity(scene);
    EXPECT_GT(compare(scene.render(), unlit).Max, 0.02);
    addLight(scene.Renderer, 3.0, 4.0, 1.5);
    addFadingLight(scene.Renderer);
    addSpotlight(scene.Renderer);
    expectParity(scene);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, LitIndependentMeshComponents,
  ::testing::Values(Mixes[0], Mixes[1], Mixes[2]), [](const auto& of) { return of.param.Name; });
} // namespace
