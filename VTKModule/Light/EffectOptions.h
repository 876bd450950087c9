// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The options of light that are not those of lights and of the volume's property.
#ifndef TetMarchLightEffectOptions_h
#define TetMarchLightEffectOptions_h

#include "Appearance/Blending.h"

namespace tetmarch
{

/** Where it is found out how much light comes through the volume. */
enum class ShadowMethod
{
  Off,
  Automatic, // whichever is cheaper
  AtVertices,
  AlongRays
};

/** What the march draws: the volume, or something of it. */
enum class Subject
{
  Picture,
  Illumination, // light without the volume's own colour
  Gradients     // their directions as colours
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
  bool OpaqueShadows = false; // where the volume casts shadows, opaque geometry does, too
  Subject Shown = Subject::Picture;
  BlendMode Blend = BlendMode::Composite;

  /** Whether what is drawn has surfaces, which have gradients and may be lit. */
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
