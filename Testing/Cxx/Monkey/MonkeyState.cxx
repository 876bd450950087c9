// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MonkeyState.h"

#include "MonkeyGrids.h"

#include <cmath>

namespace tetmarch::testing
{
MonkeyState atRest(const MonkeyState& state)
{
  MonkeyState rest = state;
  rest.FrameTimeBudget = 0.0;
  rest.UpdateRate = 0.0001;
  return rest;
}

MonkeyState timeless(const MonkeyState& state)
{
  constexpr double LeastKept = 0.1; // seconds that some machine keeps
  const auto budget = [](double seconds)
  { return seconds > 0 ? (seconds < LeastKept ? 1e-12 : 1e6) : 0.0; };
  MonkeyState same = state;
  same.FrameTimeBudget = budget(state.FrameTimeBudget);
  same.MaxDrawTime = budget(state.MaxDrawTime);
  same.LightTimeBudget = budget(state.LightTimeBudget);
  same.UpdateRate = 1.0 / budget(1.0 / state.UpdateRate);
  return same;
}

MonkeyState mended(const MonkeyState& state)
{
  MonkeyState sound = state;
  if (sound.Array == MonkeyState::Absent)
  {
    sound.Array = MonkeyState::OfPoints;
  }
  sound.VectorComponent = 0;
  sound.BlendMode =
    sound.BlendMode > Mapper::ISOSURFACE_BLEND ? Mapper::COMPOSITE_BLEND : sound.BlendMode;
  sound.IsoValues = sound.IsoValues > 32 ? 3 : sound.IsoValues;
  sound.UnitDistance = sound.UnitDistance > 0 ? sound.UnitDistance : 0.25;
  sound.Placement = sound.Placement == MonkeyState::Flat ? MonkeyState::AtHome : sound.Placement;
  sound.MaxMemory = 0;
  sound.RangeLow = sound.RangeLow > 0 ? sound.RangeLow : 1e-6;
  sound.CroppingLow = sound.CroppingLow < 1.0 ? sound.CroppingLow : 0.25;
  if (sound.Planes.size() > 4)
  {
    sound.Planes.resize(1);
  }
  for (MonkeyPlane& plane : sound.Planes)
  {
    if (plane.Normal == Vec3{ 0, 0, 0 })
    {
      plane.Normal = { { 1.0, 0.2, 0.1 } };
    }
  }
  return sound;
}

namespace
{
BlendGroup blendGroupOf(int mode)
{
  switch (mode)
  {
    case Mapper::MAXIMUM_INTENSITY_BLEND:
    case Mapper::MINIMUM_INTENSITY_BLEND:
      return BlendGroup::Extreme;
    case Mapper::AVERAGE_INTENSITY_BLEND:
    case Mapper::ADDITIVE_BLEND:
      return BlendGroup::Sum;
    case Mapper::ISOSURFACE_BLEND:
      return BlendGroup::Isosurfaces;
    default:
      return BlendGroup::Composite;
  }
}
} // namespace

VariantKey variantOf(const MonkeyState& state)
{
  const MonkeyTraits& traits = traitsOf(state.Dataset);
  VariantKey key;
  key.PointScalars = state.Array != MonkeyState::OfCells;
  key.EntryLists = !state.isInside();
  key.Hierarchy = !traits.Convex;
  key.OpaqueDepth = state.Ball;
  key.Adaptive = state.Accuracy != Mapper::FAST || state.ErrorBudget > 0;
  key.Diagnostics = state.Diagnostics || state.showsMeasure();
  key.Peeled = state.peels();
  key.TransparentRanges = state.Functions == MonkeyState::Spiky;
  key.VisiblePart = key.TransparentRanges; // mostly
  key.ConstantColor = state.Functions == MonkeyState::OneColor;
  key.Clipped = !state.Planes.empty() || state.Cropping;
  key.Cropped = state.Cropping && state.CroppingFlags != VTK_CROP_SUBVOLUME;
  key.NanShown = state.DrawNan && traits.HasNan;
  key.HiddenCells = traits.HasHidden;
  key.Blend = blendGroupOf(state.BlendMode);
  key.CellGradients = state.GradientType == Mapper::CELL_GRADIENTS;
  key.GradientOpacity = state.GradientOpacity;
  key.Shading = state.Shade && state.Lights != MonkeyState::NoLight;
  key.HeadlightOnly = state.Lights == MonkeyState::Headlight;
  key.SingleLight = state.Lights == MonkeyState::Sun;
  key.WorldLights = state.Lights == MonkeyState::SunAndPointLight ||
                    state.Lights == MonkeyState::AllLights ||
                    state.Placement == MonkeyState::Stretched;
  const bool shadows = state.Shadows != Mapper::SHADOWS_OFF || state.Scattering > 0;
  key.Scattering = state.Scattering > 0;
  key.CastShadows = shadows && state.Lights != MonkeyState::Headlight;
  key.SeveralShadows = state.Lights != MonkeyState::Sun;
  key.SampledShadows = state.Shadows == Mapper::SHADOWS_ALONG_RAYS;
  key.OpaqueShadows = state.OpaqueShadows && state.Ball;
  key.HeadlightShadows = shadows && state.Lights != MonkeyState::SunAndPointLight;
  key.Occlusion = state.Occlusion;
  key.ShowIllumination = state.ViewMode == Mapper::VIEW_ILLUMINATION;
  key.ShowGradients = state.ViewMode == Mapper::VIEW_GRADIENTS;
  return state.showsBoundary() ? key.ofEntries() : key.filtered();
}

std::vector<std::string> refusalsOf(const MonkeyState& state)
{
  std::vector<std::string> words;
  const auto refuse = [&](bool refused, const char* word)
  {
    if (refused)
    {
      words.emplace_back(word);
    }
  };
  refuse(state.Array == MonkeyState::Absent, "\"absent\"");
  refuse(state.VectorMode == Mapper::COMPONENT && state.Array == MonkeyState::OfPoints &&
           state.VectorComponent >= traitsOf(state.Dataset).Components,
    "has no component");
  refuse(state.VectorMode == Mapper::COMPONENT && state.Array == MonkeyState::OfCells &&
           state.VectorComponent > 0,
    "has no component");
  refuse(state.BlendMode > Mapper::ISOSURFACE_BLEND, "The blend mode is");
  refuse(state.BlendMode == Mapper::ISOSURFACE_BLEND && state.IsoValues > 32, "isosurface values");
  refuse(!(state.UnitDistance > 0), "unit distance");
  refuse(state.Placement == MonkeyState::Flat, "singular");
  refuse(state.Planes.size() > 32, "clipping planes");
  for (const MonkeyPlane& plane : state.Planes)
  {
    refuse(plane.Normal == Vec3{ 0, 0, 0 }, "is none: its normal");
  }
  refuse(std::isnan(state.CroppingLow) && state.Cropping, "cropping region plane");
  refuse(state.MaxMemory > 0, "MaxMemoryInBytes");
  refuse(state.showsMeasure() && !state.AutomaticRange &&
           state.ViewMode == Mapper::VIEW_ERROR_BOUND && state.RangeLow <= 0,
    "logarithmic scale");
  return words;
}
} // namespace tetmarch::testing
