// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The table of Documentation/Combinations.md: each effect of light, blend mode and view together
// with all that cuts or hides parts of the volume.
#include "BlendParity.h"
#include "CutScene.h"
#include "GapScene.h"

#include "vtkActor.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 96;

// A feature that is added to a scene.
struct Feature
{
  const char* Name;
  void (*Add)(BlendScene& scene);
};

std::ostream& operator<<(std::ostream& out, const Feature& feature) { return out << feature.Name; }

void breakScalars(BlendScene& scene) { breakSome(scene.Data->GetPointData()->GetScalars()); }

const Feature Gaps[] = {
  { "ClippingPlanes", [](BlendScene& scene) { clipObliquely(scene); } },
  { "CroppedBox", [](BlendScene& scene) { crop(scene, VTK_CROP_SUBVOLUME); } },
  { "CroppedRegions", [](BlendScene& scene) { crop(scene, VTK_CROP_FENCE & ~0x1000); } },
  { "NanPassed", breakScalars },
  { "NanShown",
    [](BlendScene& scene)
    {
      breakScalars(scene);
      scene.Mapper->DrawNanCellsOn();
      scene.property()->GetRGBTransferFunction()->SetNanColorRGBA(0.9, 0.2, 0.7, 0.4);
    } },
  { "HiddenCells", [](BlendScene& scene) { hide(scene.Data, isCrumb); } },
};

// Shadows of opaque geometry and scattering come with those of the volume at vertices.
const Feature Effects[] = {
  { "gradient opacity and ambient occlusion",
    [](BlendScene& scene)
    {
      scene.addGradientOpacity();
      scene.Mapper->AmbientOcclusionOn();
    } },
  { "shadows of a headlight",
    [](BlendScene& scene)
    {
      scene.Sun->SetLightTypeToHeadlight();
      scene.Mapper->SetShadowMethodToAtVertices();
    } },
  { "opaque shadows",
    [](BlendScene& scene)
    {
      scene.Renderer->AddActor(makeBall({ 2.0, 2.6, 1.1 }, 0.35, { 1.0, 1.0, 1.0 }));
      scene.Mapper->SetShadowMethodToAtVertices();
      scene.Mapper->OpaqueShadowsOn();
    } },
  { "scattering",
    [](BlendScene& scene)
    {
      scene.Mapper->SetShadowMethodToAtVertices();
      scene.Mapper->SetVolumetricScatteringBlending(1.3f);
    } },
};

Grid lattice(int n) { return jitteredLattice(n, 0.15, 1, sineField()); }

class Combinations : public testing::TestWithParam<Feature>
{
};

// The window shows without diagnostics what was compared with them, and the views of error and cost
// are those of that picture.
void expectTheSameInTheWindow(Scene& scene, const Image& drawn)
{
  EXPECT_LE(compare(scene.frame(), drawn, {}, 0.0, Channels::Rgb).Max, 1.0 / 255.0);
  scene.Mapper->SetViewModeToCells();
  EXPECT_EQ(compare(scene.render(), drawn).Max, 0.0);
  scene.Mapper->SetViewModeToPicture();
}

TEST_P(Combinations, Effects)
{
  for (const Feature& effect : Effects)
  {
    SCOPED_TRACE(effect.Name);
    BlendScene scene(lattice(7), Side, Side);
    this->GetParam().Add(scene);
    const Image shaded = scene.render();
    effect.Add(scene);
    expectParityWithOpaque(scene);
    const Image drawn = scene.render();
    EXPECT_GT(compare(drawn, shaded).Max, 0.02) << "the effect isn't there";
    if (scene.Renderer->GetActors()->GetNumberOfItems() == 0)
    {
      expectTheSameInTheWindow(scene, drawn);
    }
  }
}

// Unlit and shaded pictures; and the view of the illumination is the picture of a white volume.
TEST_P(Combinations, ShadingAndViewsOfIt)
{
  BlendScene scene(lattice(7), Side, Side);
  const Image whole = scene.render();
  this->GetParam().Add(scene);
  expectParity(scene);
  const Image shaded = scene.render();
  EXPECT_GT(compare(shaded, whole).Max, 0.1) << "nothing is cut or hidden";
  expectTheSameInTheWindow(scene, shaded);

  // How far segments are split depends on colours, which the illumination has none of.
  scene.Mapper->SetAccuracyLevelToFast();
  scene.Mapper->SetViewModeToGradients();
  const Image gradients = scene.render();
  scene.Mapper->SetViewModeToIllumination();
  const Image illumination = scene.render();
  EXPECT_LE(compare(illumination, scene.renderWhite()).Max, 1e-4);
  EXPECT_GT(compare(illumination, shaded).Max, 0.1);
  double worst = 0.0;
  for (std::size_t i = 3; i < shaded.Rgba.size(); i += 4)
  {
    worst = std::max(worst, std::abs(double(gradients.Rgba[i] - shaded.Rgba[i])));
  }
  EXPECT_LE(worst, 2.0 / 255.0) << "as opaque as the picture";

  scene.property()->ShadeOff();
  expectParity(scene);
}

// Light that is sampled at random points of rays, against light computed in all places.
TEST_P(Combinations, ShadowsAlongRays)
{
  BlendScene scene(lattice(5), 64, 64);
  scene.property()->SetScalarOpacityUnitDistance(0.6);
  this->GetParam().Add(scene);
  const Image shaded = scene.render();
  scene.Mapper->SetShadowMethodToAlongRays();
  const Image drawn = scene.render();
  expectLightAlongRays(scene, drawn, shaded);
  expectTheSameInTheWindow(scene, drawn);
}

TEST_P(Combinations, BlendModes)
{
  BlendScene scene(lattice(7), Side, Side);
  this->GetParam().Add(scene);
  expectBlendParity(scene);
}

// These views show the mesh, whatever of the volume is drawn.
TEST_P(Combinations, ViewsOfTheBoundaryShowAllOfIt)
{
  BlendScene scene(lattice(5), Side, Side);
  scene.Mapper->SetViewModeToBoundaryFaces();
  scene.Window->Render();
  const Image boundary = scene.frame();
  EXPECT_GT(boundary.pixel(Side / 2, Side / 2)[0], 0.2f);
  this->GetParam().Add(scene);
  for (const Feature& effect : Effects)
  {
    effect.Add(scene);
  }
  scene.Renderer->RemoveAllViewProps();
  scene.Renderer->AddVolume(scene.Volume);
  scene.Window->Render();
  EXPECT_EQ(compare(scene.frame(), boundary).Max, 0.0);
}

INSTANTIATE_TEST_SUITE_P(
  With, Combinations, testing::ValuesIn(Gaps), [](const auto& of) { return of.param.Name; });

// Effects that a blend mode doesn't use change nothing of its picture.
TEST(CombinationRules, BlendModesHaveNoLightThroughTheVolume)
{
  BlendScene scene(lattice(5), 64, 64);
  for (const int mode : BlendModes)
  {
    SCOPED_TRACE(scene.Mapper->GetBlendModeAsString());
    scene.Mapper->SetBlendMode(mode);
    for (const bool head : { false, true })
    {
      scene.Sun->SetLightType(head ? VTK_LIGHT_TYPE_HEADLIGHT : VTK_LIGHT_TYPE_SCENE_LIGHT);
      scene.property()->GetGradientOpacity()->RemoveAllPoints();
      scene.property()->DisableGradientOpacityOn();
      scene.Mapper->SetShadowMethodToOff();
      scene.Mapper->AmbientOcclusionOff();
      scene.Mapper->SetVolumetricScatteringBlending(0.0f);
      const Image without = scene.render();
      scene.addGradientOpacity();
      scene.property()->DisableGradientOpacityOff();
      scene.Mapper->SetShadowMethodToAlongRays();
      scene.Mapper->AmbientOcclusionOn();
      scene.Mapper->SetVolumetricScatteringBlending(1.3f);
      EXPECT_EQ(compare(scene.render(), without).Max > 0.0, mode == Mapper::COMPOSITE_BLEND);
    }
  }
}

// Scalars that are not finite have a colour in composite blending alone.
TEST(CombinationRules, BlendModesPassWhatIsNotFinite)
{
  for (const int mode : BlendModes)
  {
    BlendScene scene(lattice(5), 64, 64);
    scene.Mapper->SetBlendMode(mode);
    breakScalars(scene);
    const Image passed = scene.render();
    scene.Mapper->DrawNanCellsOn();
    EXPECT_EQ(compare(scene.render(), passed).Max > 0.0, mode == Mapper::COMPOSITE_BLEND)
      << scene.Mapper->GetBlendModeAsString();
  }
}
} // namespace
