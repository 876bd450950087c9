// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Lights in the terms of the march: what Shaders/light/light_buffers.glsl, light_ray_buffers.glsl
// and vertex_ray_buffers.glsl have as uniforms.
#ifndef TetMarchLightLightUniforms_h
#define TetMarchLightLightUniforms_h

#include "Light/EffectOptions.h"
#include "Light/Lighting.h"

#include <array>
#include <vector>

class vtkVolume;

namespace tetmarch
{

struct TetMesh;

/**
 * Angles are the same in the normalised frame of the mesh and in the world, unless the volume is
 * stretched: light from far away is reckoned in the frame of the mesh then, which spares the march
 * two transforms a point. Otherwise, and where distances from lights count, it is reckoned in world
 * coordinates, which begin at the centre of the mesh here and whose unit is such that float can
 * tell the mesh whatever its size.
 */
struct LightUniforms
{
  struct Light
  {
    std::array<double, 3> Diffuse{}; // times that of the volume's property
    std::array<double, 3> Specular{};
    std::array<double, 4> Place{}; // position, 1; or unit vector to the light, 0
    std::array<double, 4> Attenuation{ { 1, 0, 0,
      0 } }; // attenuation: constant, linear, quadratic; exponent of the spot
    std::array<double, 4> Cone{ { 0, 0, 0, -1 } }; // where it shines, cosine of the cone's angle
    bool Headlight = false;
    double ShadowStrength = 0;
    int ShadowChannel = -1; // of the light at vertices; -1: it casts none, or stands at the eye
  };
  /** That many lights may cast shadows, beside the headlights. */
  static constexpr int MostShadowSources = 3;

  std::vector<Light> Sources;
  bool InWorld = false; // else in the normalised frame of the mesh, and the matrices say nothing
  std::array<double, 9> WorldMatrix{ { 1, 0, 0, 0, 1, 0, 0, 0, 1 } };  // of vectors of that frame
  std::array<double, 9> NormalMatrix{ { 1, 0, 0, 0, 1, 0, 0, 0, 1 } }; // of gradients there
  bool TwoSided = false;
  std::array<double, 3> Ambient{};
  double SpecularPower = 1;
  double ScatteringBlending = 0; // 0..1

  std::vector<std::array<double, 4>> ShadowSources; // as Place, but in the normalised frame
  double Reach = 0;                                 // in the normalised frame
  double OpaqueReach = 0; // the same for opaque geometry: infinity if all the way
  int OcclusionDirections = 0;
  double OcclusionRadius = 0;
  int ShadowlessLights = 0; // that would have cast shadows, had there been fewer

  bool hasHeadlightShadows() const;
  bool isHeadlightOnly() const { return this->Sources.size() == 1 && this->Sources[0].Headlight; }
  /** Whether light is kept at vertices or looked for: something casts shadows, or ambient light is
   * occluded. */
  bool hasVolumeLight() const
  {
    return !this->ShadowSources.empty() || this->OcclusionDirections > 0;
  }
};

/** No lights if nothing is lit. */
LightUniforms makeLightUniforms(
  const Lighting& lighting, const EffectOptions& options, vtkVolume* volume, const TetMesh& mesh);

} // namespace tetmarch

#endif
