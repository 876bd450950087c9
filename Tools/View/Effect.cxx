// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Effect.h"

#include "vtkTetMarchSettings.h"

#include <QtGlobal>

namespace
{
using tetmarch::SettingsState;
using tetmarch::ViewState;

constexpr auto Shadows = &SettingsState::ShadowMethod;
constexpr int AtVertices = vtkTetMarchSettings::SHADOWS_AT_VERTICES;
constexpr int AlongRays = vtkTetMarchSettings::SHADOWS_ALONG_RAYS;
constexpr auto Preset = &SettingsState::LightPreset;

template <auto Choice, int Value>
bool IsChosen(const ViewState& s)
{
  return s.Settings.*Choice == Value;
}

/// Of several effects one at most is chosen; 0 is none.
template <auto Choice, int Value>
void Choose(ViewState& s, bool on)
{
  int& chosen = s.Settings.*Choice;
  chosen = on ? Value : chosen == Value ? 0 : chosen;
  s.Effects.Shading |= on;
}

/// Without shading there are none of the other effects of light.
void SetShading(ViewState& s, bool on)
{
  s.Effects.Shading = on;
  if (!on)
  {
    s.Settings.ShadowMethod = 0;
    s.Settings.LightPreset = 0;
    s.Settings.AmbientOcclusion = false;
    s.Effects.Scattering = false;
    s.Settings.OpaqueShadows = false;
    s.Settings.LightTolerance = 0.0;
    s.Settings.LightThroughCuts = false;
  }
}

void SetLightTolerance(ViewState& s, bool on)
{
  s.Settings.LightTolerance = on ? 2.0 / 255.0 : 0.0;
  s.Effects.Shading |= on;
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
    { QT_TR_NOOP("Light of a studio"),
      QT_TR_NOOP(
        "Three lights that go with the camera, and ambient occlusion, in place of the light "
        "below"),
      IsChosen<Preset, vtkTetMarchSettings::LIGHT_STUDIO>,
      Choose<Preset, vtkTetMarchSettings::LIGHT_STUDIO> },
    { QT_TR_NOOP("Light at the camera"),
      QT_TR_NOOP("A bright light at the camera, in place of the light below"),
      IsChosen<Preset, vtkTetMarchSettings::LIGHT_HEADLIGHT>,
      Choose<Preset, vtkTetMarchSettings::LIGHT_HEADLIGHT> },
    { QT_TR_NOOP("Light of the sun"),
      QT_TR_NOOP("From above, with shadows and ambient occlusion, in place of the light below"),
      IsChosen<Preset, vtkTetMarchSettings::LIGHT_SUN>,
      Choose<Preset, vtkTetMarchSettings::LIGHT_SUN> },
    { QT_TR_NOOP("Gradient opacity"), QT_TR_NOOP("Less opaque where the gradient is small"),
      [](const ViewState& s) { return s.Effects.GradientOpacity; },
      [](ViewState& s, bool on) { s.Effects.GradientOpacity = on; } },
    { QT_TR_NOOP("Shadows at vertices"),
      QT_TR_NOOP("Shadows of the volume on itself, stored at the vertices"),
      IsChosen<Shadows, AtVertices>, Choose<Shadows, AtVertices> },
    { QT_TR_NOOP("Shadows along rays"),
      QT_TR_NOOP("Shadows of the volume on itself, sampled along each ray in each frame"),
      IsChosen<Shadows, AlongRays>, Choose<Shadows, AlongRays> },
    { QT_TR_NOOP("Light within 2/255"),
      QT_TR_NOOP(
        "Light and shadows at more points of each ray, until the estimated error of a pixel is at "
        "most 2/255"),
      [](const ViewState& s) { return s.Settings.LightTolerance > 0.0; }, SetLightTolerance },
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
    { QT_TR_NOOP("Light through cuts"),
      QT_TR_NOOP("Light passes through what is clipped or cropped away"),
      [](const ViewState& s) { return s.Settings.LightThroughCuts; },
      SetLight<&ViewState::Settings, &SettingsState::LightThroughCuts> },
  };
  return effects;
}
