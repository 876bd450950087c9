// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What shines on a volume and how it answers, as vtkRenderer's lights and vtkVolumeProperty say.
#ifndef TetMarchLightLighting_h
#define TetMarchLightLighting_h

#include <array>
#include <vector>

class vtkRenderer;
class vtkVolumeProperty;

namespace tetmarch
{

/** More lights than these are left out: a frame's time grows with each. */
constexpr int MostLights = 16;

struct LightSource
{
  bool Positional = false;
  std::array<double, 3> Position{};                // world; of positional lights
  std::array<double, 3> Direction{ { 0, 0, -1 } }; // world, unit length: the way the light travels
  std::array<double, 3> Ambient{};                 // colours times intensity
  std::array<double, 3> Diffuse{};
  std::array<double, 3> Specular{};
  std::array<double, 3> Attenuation{ { 1, 0, 0 } }; // constant, linear, quadratic
  double ConeCosine = -1;                           // of a spot light; -1: shines in all directions
  double Exponent = 0;                              // of a spot light
  double ShadowStrength = 0;                        // 0..1
  bool Headlight = false; // shines from the eye along each ray; not positional
};

struct Lighting
{
  std::vector<LightSource> Lights; // in the renderer's order
  bool TwoSided = false;
  double Ambient = 0; // and the others, of component 0
  double Diffuse = 0;
  double Specular = 0;
  double SpecularPower = 0;
  int LeftOut = 0; // lights beyond MostLights
};

/**
 * Lights that are on, have an intensity and some colour. Left out is what has no use: a light of
 * numbers that aren't finite, and a directional light or a spot whose focal point is its position.
 * Headlights and camera lights stand where the renderer put them at the frame's begin
 * (vtkRenderer::UpdateLightsGeometryToFollowCamera()). Lights is empty if shading is off or no
 * light shines: then nothing is to be lit.
 */
Lighting lightingOf(vtkRenderer* renderer, vtkVolumeProperty* property);

} // namespace tetmarch

#endif
