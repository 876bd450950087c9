// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Effect.h"

#include "vtkTetMarchSettings.h"

#include <QtGlobal>

namespace
{
using tetmarch::EffectState;

constexpr int Off = vtkTetMarchSettings::SHADOWS_OFF;
constexpr int AtVertices = vtkTetMarchSettings::SHADOWS_AT_VERTICES;
constexpr int AlongRays = vtkTetMarchSettings::SHADOWS_ALONG_RAYS;

template <int Method>
bool HasShadows(const EffectState& s)
{
  return s.Shadows == Method;
}

template <int Method>
void SetShadows(EffectState& s, bool on)
{
  s.Shadows = on ? Method : s.Shadows == Method ? Off : s.Shadows;
  s.Shading |= on;
}

/// Without shading there are none of the other effects of light.
void SetShading(EffectState& s, bool on)
{
  s.Shading = on;
  if (!on)
  {
    s.Shadows = Off;
    s.Occlusion = false;
    s.Scattering = false;
    s.OpaqueShadows = false;
  }
}

/// Of those that need it.
template <bool EffectState::*Member>
void SetLight(EffectState& s, bool on)
{
  s.*Member = on;
  s.Shading |= on;
}
} // namespace

const std::vector<tetmarch::Effect>& tetmarch::GetEffects()
{
  static const std::vector<Effect> effects = {
    { QT_TR_NOOP("Shading"), QT_TR_NOOP("Light on the surfaces of constant scalar"),
      [](const EffectState& s) { return s.Shading; }, SetShading },
    { QT_TR_NOOP("Gradient opacity"), QT_TR_NOOP("Less opaque where the gradient is small"),
      [](const EffectState& s) { return s.GradientOpacity; },
      [](EffectState& s, bool on) { s.GradientOpacity = on; } },
    { QT_TR_NOOP("Shadows at vertices"),
      QT_TR_NOOP("Shadows of the volume on itself, stored at the vertices"), HasShadows<AtVertices>,
      SetShadows<AtVertices> },
    { QT_TR_NOOP("Shadows along rays"),
      QT_TR_NOOP("Shadows of the volume on itself, sampled along each ray in each frame"),
      HasShadows<AlongRays>, SetShadows<AlongRays> },
    { QT_TR_NOOP("Ambient occlusion"), QT_TR_NOOP("The volume blocks ambient light"),
      [](const EffectState& s) { return s.Occlusion; }, SetLight<&EffectState::Occlusion> },
    { QT_TR_NOOP("Scattering"), QT_TR_NOOP("Light is scattered where there is no clear surface"),
      [](const EffectState& s) { return s.Scattering; }, SetLight<&EffectState::Scattering> },
    { QT_TR_NOOP("Opaque shadows"),
      QT_TR_NOOP("The opaque surface casts shadows on the volume, if the volume casts shadows"),
      [](const EffectState& s) { return s.OpaqueShadows; }, SetLight<&EffectState::OpaqueShadows> },
  };
  return effects;
}
