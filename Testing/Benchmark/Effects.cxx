// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Effects.h"

#include "vtkLight.h"
#include "vtkLightKit.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkTetMarchVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::bench
{
namespace
{
using Place = std::array<double, 3>;

// From above and beside: neither along an axis of a lattice nor where the camera stands.
constexpr Place TowardsLight = { { 0.4, -0.7, 0.6 } };

double diagonalOf(const EffectScene& scene)
{
  const auto& b = scene.Bounds;
  return std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
}

/// So many diagonals from the middle of the grid.
Place placeOf(const EffectScene& scene, const Place& offset)
{
  Place place{};
  for (int i = 0; i < 3; ++i)
  {
    place[i] =
      0.5 * (scene.Bounds[2 * i] + scene.Bounds[2 * i + 1]) + diagonalOf(scene) * offset[i];
  }
  return place;
}

/// A light of the scene that shines towards the middle of the grid.
vtkSmartPointer<vtkLight> addLight(const EffectScene& scene, const Place& offset)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(placeOf(scene, offset).data());
  light->SetFocalPoint(placeOf(scene, {}).data());
  scene.Renderer->AddLight(light);
  return light;
}

void applyGradientOpacity(const EffectScene& scene)
{
  // No less than a half, so that rays go about as far as without.
  constexpr double steep = 4.0;
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.5);
  opacity->AddPoint(steep * scene.ScalarWidth / diagonalOf(scene), 1.0);
  scene.Property->SetGradientOpacity(opacity);
  scene.Property->DisableGradientOpacityOff();
}

void applyHeadlight(const EffectScene& scene)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  scene.Renderer->AddLight(light);
  scene.Property->ShadeOn();
}

void applyOneLight(const EffectScene& scene)
{
  addLight(scene, TowardsLight);
  scene.Property->ShadeOn();
}

void applyLightKit(const EffectScene& scene)
{
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(scene.Renderer);
  scene.Property->ShadeOn();
}

void applyLocalLights(const EffectScene& scene)
{
  constexpr double spotAngle = 30.0;
  constexpr Place elsewhere = { { -0.8, -0.5, 0.3 } };
  const auto point = addLight(scene, elsewhere);
  point->PositionalOn();
  point->SetConeAngle(180.0); // no spot
  const auto spot = addLight(scene, TowardsLight);
  spot->PositionalOn();
  spot->SetConeAngle(spotAngle);
  scene.Property->ShadeOn();
}

void applyCellGradients(const EffectScene& scene)
{
  applyOneLight(scene);
  scene.Mapper->SetGradientTypeToCell();
}

void applyVertexShadows(const EffectScene& scene)
{
  applyOneLight(scene);
  scene.Mapper->SetShadowMethodToAtVertices();
}

void applyRayShadows(const EffectScene& scene)
{
  applyOneLight(scene);
  scene.Mapper->SetShadowMethodToAlongRays();
}

void applyHeadlightShadows(const EffectScene& scene)
{
  applyHeadlight(scene);
  scene.Mapper->SetShadowMethodToAtVertices();
}

void applyOcclusion(const EffectScene& scene)
{
  applyOneLight(scene);
  scene.Mapper->AmbientOcclusionOn();
}

void applyShadowsAndOcclusion(const EffectScene& scene)
{
  applyVertexShadows(scene);
  scene.Mapper->AmbientOcclusionOn();
}

void applyScattering(const EffectScene& scene)
{
  applyVertexShadows(scene);
  scene.Mapper->SetVolumetricScatteringBlending(1.0f);
}

void applyIllumination(const EffectScene& scene)
{
  applyOneLight(scene);
  scene.Mapper->SetViewModeToIllumination();
}

void applyNothing(const EffectScene& scene)
{
  scene.Renderer->RemoveAllLights();
  scene.Property->ShadeOff();
  scene.Property->SetAmbient(0.3);
  scene.Property->SetDiffuse(0.7);
  scene.Property->SetSpecular(0.3);
  scene.Property->SetSpecularPower(20.0);
  scene.Property->DisableGradientOpacityOn();
  scene.Mapper->SetGradientTypeToVertex();
  scene.Mapper->SetShadowMethodToOff();
  scene.Mapper->SetVolumetricScatteringBlending(0.0f);
  scene.Mapper->AmbientOcclusionOff();
  scene.Mapper->SetViewModeToPicture();
}
} // namespace

const std::string NoEffect = "base";

const std::vector<Effect>& effects()
{
  static const std::vector<Effect> all = {
    { "gradient-opacity", "gradient opacity", NoEffect, applyGradientOpacity },
    { "headlight", "shading by the headlight", NoEffect, applyHeadlight },
    { "one-light", "shading by one directional light of the scene", NoEffect, applyOneLight },
    { "five-lights", "shading by the five lights of vtkLightKit", NoEffect, applyLightKit },
    { "local-lights", "shading by a point light and a spot light", NoEffect, applyLocalLights },
    { "cell-gradients", "one light, gradients of cells", "one-light", applyCellGradients },
    { "vertex-shadows", "one light, shadows at vertices", "one-light", applyVertexShadows },
    { "ray-shadows", "one light, shadows along rays", "one-light", applyRayShadows },
    { "headlight-shadows", "headlight and its shadows", "headlight", applyHeadlightShadows },
    { "occlusion", "one light, ambient occlusion", "one-light", applyOcclusion },
    { "shadows-occlusion", "one light, shadows at vertices, ambient occlusion", "one-light",
      applyShadowsAndOcclusion },
    { "scattering", "one light, shadows at vertices, scattering 1", "vertex-shadows",
      applyScattering },
    { "illumination", "one light, view of the illumination", "one-light", applyIllumination },
  };
  return all;
}

bool isEffect(const std::string& name)
{
  return std::any_of(effects().begin(), effects().end(),
    [&name](const Effect& effect) { return effect.Name == name; });
}

void applyEffect(const std::string& name, const EffectScene& scene)
{
  applyNothing(scene);
  for (const Effect& effect : effects())
  {
    if (effect.Name == name)
    {
      effect.Apply(scene);
    }
  }
}
} // namespace tetmarch::bench
