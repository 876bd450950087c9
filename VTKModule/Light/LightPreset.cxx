// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/LightPreset.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

using Triple = std::array<double, 3>;

struct PresetLight
{
  Triple From; // to the right, above, in front
  Triple Colour;
  double Shadow; // 0..1
};

struct Preset
{
  bool InWorld; // else to the right of the camera, above it, behind it
  double Ambient, Diffuse, Specular, SpecularPower;
  std::vector<PresetLight> Lights;
  ShadowMethod Shadows;
  bool Occlusion;
};

// A warm key light, a cool fill light from the other side, a light from behind for the rim.
const Preset Studio = { false, 0.3, 0.9, 0.35, 30,
  { { { { -0.7, 0.75, 0.45 } }, { { 1.05, 1.0, 0.94 } }, 0 },
    { { { 0.8, -0.1, 0.6 } }, { { 0.18, 0.2, 0.24 } }, 0 },
    { { { 0.3, 0.6, -0.8 } }, { { 0.3, 0.3, 0.3 } }, 0 } },
  ShadowMethod::Off, true };
const Preset Headlight = { false, 0.25, 0.8, 0.3, 25, { { { { 0, 0, 1 } }, { { 1, 1, 1 } }, 0 } },
  ShadowMethod::Off, false };
const Preset Sun = { true, 0.45, 1.0, 0.2, 20,
  { { { { -0.45, 0.7, 0.55 } }, { { 1.35, 1.3, 1.2 } }, 1 } }, ShadowMethod::Automatic, true };

const Preset& presetOf(LightPreset preset)
{
  return preset == LightPreset::Studio ? Studio : preset == LightPreset::Sun ? Sun : Headlight;
}

// Rows: the directions to the right, up and to the front.
using Basis = std::array<Triple, 3>;

Basis basisOfCamera(vtkCamera* camera)
{
  Basis basis;
  for (int row = 0; row < 3; ++row)
  {
    for (int k = 0; k < 3; ++k)
    {
      basis[row][k] = camera->GetViewTransformMatrix()->GetElement(row, k);
    }
  }
  return basis;
}

// The axis nearest to the camera's direction of up is up. To the right is x, or y if x is up.
Basis basisOfWorld(vtkCamera* camera)
{
  const double* up = camera->GetViewUp();
  const auto isLonger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto axis = std::max_element(up, up + 3, isLonger) - up;
  Basis basis{};
  basis[0][axis == 0 ? 1 : 0] = 1;
  basis[1][axis] = up[axis] < 0 ? -1 : 1;
  vtkMath::Cross(basis[0].data(), basis[1].data(), basis[2].data());
  return basis;
}

// The way the light travels.
Triple directionOf(const PresetLight& light, const Basis& basis)
{
  Triple direction{};
  for (int row = 0; row < 3; ++row)
  {
    for (int k = 0; k < 3; ++k)
    {
      direction[k] -= light.From[row] * basis[row][k];
    }
  }
  vtkMath::Normalize(direction.data());
  return direction;
}

} // namespace

Lighting presetLighting(LightPreset preset, vtkRenderer* renderer)
{
  const Preset& of = presetOf(preset);
  vtkCamera* camera = renderer->GetActiveCamera();
  const Basis basis = of.InWorld ? basisOfWorld(camera) : basisOfCamera(camera);
  Lighting lighting;
  lighting.TwoSided = renderer->GetTwoSidedLighting() != 0;
  lighting.Ambient = of.Ambient;
  lighting.Diffuse = of.Diffuse;
  lighting.Specular = of.Specular;
  lighting.SpecularPower = of.SpecularPower;
  for (const PresetLight& light : of.Lights)
  {
    LightSource source;
    source.Direction = directionOf(light, basis);
    source.Diffuse = light.Colour;
    source.Specular = light.Colour;
    source.ShadowStrength = light.Shadow;
    source.Headlight = preset == LightPreset::Headlight;
    lighting.Lights.push_back(source);
  }
  return lighting;
}

EffectOptions withPreset(EffectOptions options)
{
  if (options.Preset != LightPreset::OfScene)
  {
    const Preset& of = presetOf(options.Preset);
    options.Shadows = options.Shadows == ShadowMethod::Off ? of.Shadows : options.Shadows;
    options.Occlusion = options.Occlusion || of.Occlusion;
  }
  return options;
}

} // namespace tetmarch
