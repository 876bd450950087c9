// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The lights of a vtkRenderer, and the reflection of a volume by its vtkVolumeProperty.
#ifndef TetMarchLightLighting_h
#define TetMarchLightLighting_h

#include <array>
#include <vector>

class vtkRenderer;
class vtkVolumeProperty;

namespace tetmarch
{

/** Maximum number of lights: each increases the time of a frame. */
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
  double Ambient = 0; // all four are those of component 0
  double Diffuse = 0;
  double Specular = 0;
  double SpecularPower = 0;
  int LeftOut = 0; // lights beyond MostLights
};

/**
 * The lights that are on and not dark, except lights with numbers that aren't finite, and
 * directional lights and spots whose focal point is their position. The positions of headlights and
 * camera lights are those that the renderer set at the beginning of the frame
 * (vtkRenderer::UpdateLightsGeometryToFollowCamera()). There are no lights if shading is off.
 */
Lighting lightingOf(vtkRenderer* renderer, vtkVolumeProperty* property);

} // namespace tetmarch

#endif
