// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Lights for the march: the uniforms of Shaders/light/light_buffers.glsl, light_ray_buffers.glsl
// and vertex_ray_buffers.glsl.
#ifndef TetMarchLightLightUniforms_h
#define TetMarchLightLightUniforms_h

#include "Light/EffectOptions.h"
#include "Light/Lighting.h"

#include <array>
#include <vector>

class vtkVolume;

namespace tetmarch
{

struct VolumeFrame;

/**
 * Unless the volume is stretched, angles are the same in its normalised frame and in the world.
 * Directional light is then computed in the normalised frame, which saves two transforms per point.
 * Otherwise, and for positional lights, light is computed in world coordinates, with the volume's
 * centre as origin and a unit of length such that float can represent a volume of any size.
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
    std::array<double, 4> Cone{ { 0, 0, 0, -1 } }; // direction, cosine of the cone's angle
    bool Headlight = false;
    double ShadowStrength = 0;
    int ShadowChannel = -1; // in the light at vertices; -1: it casts no shadows, or is a headlight
  };
  /** Maximum number of lights that cast shadows, without headlights. */
  static constexpr int MostShadowSources = 3;
  /** Number of lights up to which a software renderer has no loop. */
  static constexpr std::size_t FewLights = 5;

  std::vector<Light> Sources;
  bool InWorld = false; // else in the normalised frame; the matrices transform to the world
  std::array<double, 9> WorldMatrix{ { 1, 0, 0, 0, 1, 0, 0, 0, 1 } };  // of vectors
  std::array<double, 9> NormalMatrix{ { 1, 0, 0, 0, 1, 0, 0, 0, 1 } }; // of gradients
  bool TwoSided = false;
  std::array<double, 3> Ambient{};
  double SpecularPower = 1;
  double ScatteringBlending = 0; // 0..1

  std::vector<std::array<double, 4>> ShadowSources; // as Place, but in the normalised frame
  double Reach = 0;                                 // in the normalised frame
  double Tolerance = 0;                             // of a channel by light; 0: none is kept
  int TurnsOfSample = 1;    // about, of the loops of the rays from a sample of the light
  bool ThroughCuts = false; // what is clipped away absorbs no light
  double OpaqueReach = 0;   // the same for shadows of opaque geometry; infinity: no limit
  int OcclusionDirections = 0;
  double OcclusionRadius = 0;
  int ShadowlessLights = 0; // lights beyond MostShadowSources, which cast no shadows
  int LightsLeftOut = 0;    // lights beyond MostLights

  bool hasHeadlightShadows() const;
  bool isHeadlightOnly() const { return this->Sources.size() == 1 && this->Sources[0].Headlight; }
  /** Whether the transmittance of the volume is needed: a light casts shadows, or ambient light is
   * occluded. */
  bool hasVolumeLight() const
  {
    return !this->ShadowSources.empty() || this->OcclusionDirections > 0;
  }
};

/** Without lights if nothing is lit. */
LightUniforms makeLightUniforms(const Lighting& lighting, const EffectOptions& options,
  vtkVolume* volume, const VolumeFrame& frame);

} // namespace tetmarch

#endif
