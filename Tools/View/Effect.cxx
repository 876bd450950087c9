// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Effect.h"

#include "vtkTetMarchSettings.h"

#include <QtGlobal>

namespace
{
using tetmarch::SettingsState;
using tetmarch::ViewState;

constexpr int Off = vtkTetMarchSettings::SHADOWS_OFF;
constexpr int AtVertices = vtkTetMarchSettings::SHADOWS_AT_VERTICES;
constexpr int AlongRays = vtkTetMarchSettings::SHADOWS_ALONG_RAYS;

template <int Method>
bool HasShadows(const ViewState& s)
{
  return s.Settings.ShadowMethod == Method;
}

template <int Method>
void SetShadows(ViewState& s, bool on)
{
  int& method = s.Settings.ShadowMethod;
  method = on ? Method : method == Method ? Off : method;
  s.Effects.Shading |= on;
}

/// Without shading there are none of the other effects of light.
void SetShading(ViewState& s, bool on)
{
  s.Effects.Shading = on;
  if (!on)
  {
    s.Settings.ShadowMethod = Off;
    s.Settings.AmbientOcclusion = false;
    s.Effects.Scattering = false;
    s.Settings.OpaqueShadows = false;
  }
}

/// Effects that need shading switch it on.
template <auto Part, auto Member>
void SetLight(ViewState& s, bool on)
{
  s.*Part.*Member = on;
  s.Effects.Shading |= on;
}
} // namespace

const std::vector<tetmarch::Effect>& tetmarch::GetEffects()
{
  static const std::vector<Effect> effects = {
    { QT_TR_NOOP("Shading"), QT_TR_NOOP("Light on the surfaces of constant scalar"),
      [](const ViewState& s) { return s.Effects.Shading; }, SetShading },
    { QT_TR_NOOP("Gradient opacity"), QT_TR_NOOP("Less opaque where the gradient is small"),
      [](const ViewState& s) { return s.Effects.GradientOpacity; },
      [](ViewState& s, bool on) { s.Effects.GradientOpacity = on; } },
    { QT_TR_NOOP("Shadows at vertices"),
      QT_TR_NOOP("Shadows of the volume on itself, stored at the vertices"), HasShadows<AtVertices>,
      SetShadows<AtVertices> },
    { QT_TR_NOOP("Shadows along rays"),
      QT_TR_NOOP("Shadows of the volume on itself, sampled along each ray in each frame"),
      HasShadows<AlongRays>, SetShadows<AlongRays> },
    { QT_TR_NOOP("Ambient occlusion"), QT_TR_NOOP("The volume blocks ambient light"),
      [](const ViewState& s) { return s.Settings.AmbientOcclusion; },
      SetLight<&ViewState::Settings, &SettingsState::AmbientOcclusion> },
    { QT_TR_NOOP("Scattering"), QT_TR_NOOP("Light is scattered where there is no clear surface"),
      [](const ViewState& s) { return s.Effects.Scattering; },
      SetLight<&ViewState::Effects, &EffectState::Scattering> },
    { QT_TR_NOOP("Opaque shadows"),
      QT_TR_NOOP("The opaque surface casts shadows on the volume, if the volume casts shadows"),
      [](const ViewState& s) { return s.Settings.OpaqueShadows; },
      SetLight<&ViewState::Settings, &SettingsState::OpaqueShadows> },
  };
  return effects;
}
