// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Options of light, besides those of lights and of the volume's property.
#ifndef TetMarchLightEffectOptions_h
#define TetMarchLightEffectOptions_h

#include "Appearance/Blending.h"

namespace tetmarch
{

/** Where the transmittance of the volume towards the lights is computed. */
enum class ShadowMethod
{
  Off,
  Automatic, // whichever is cheaper
  AtVertices,
  AlongRays
};

/** The drawn quantity: the volume, or its illumination or gradients. */
enum class Subject
{
  Picture,
  Illumination, // light without the volume's own colour
  Gradients     // their directions as colours
};

/** The lights of a frame, its reflection, and the effects that go with them; values as in
 * vtkTetMarchSettings. */
enum class LightPreset
{
  OfScene,
  Studio,
  Headlight,
  Sun
};

struct EffectOptions
{
  bool CellGradients = false; // else interpolated between vertices
  ShadowMethod Shadows = ShadowMethod::Off;
  double Scattering = 0; // VolumetricScatteringBlending, 0..2
  double Reach = 1;      // GlobalIlluminationReach, 0..1
  bool Occlusion = false;
  double OcclusionRadius = 0.1; // of the diagonal of the mesh's bounding box
  int OcclusionDirections = 16;
  bool OpaqueShadows = false; // if the volume casts shadows, opaque geometry does, too
  Subject Shown = Subject::Picture;
  BlendMode Blend = BlendMode::Composite;
  LightPreset Preset = LightPreset::OfScene; // else shading is on, by these lights
  double Tolerance = 0;                      // of a channel by light, 0..1; 0: none is kept
  bool ThroughCuts = false;                  // what is clipped away absorbs no light

  /** Whether the blend mode draws surfaces with gradients, which may be lit. */
  bool showsSurfaces() const
  {
    return this->Blend == BlendMode::Composite || this->Blend == BlendMode::IsoSurface;
  }
};

/** The options that have an effect in the blend mode: isosurfaces have lights and gradients but no
 * shadows, and other modes than composite have neither. */
EffectOptions usedOptions(const EffectOptions& options);

} // namespace tetmarch

#endif
