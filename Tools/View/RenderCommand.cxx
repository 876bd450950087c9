// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RenderCommand.h"

#include "NumberText.h"
#include "StateWords.h"

#include "vtkTetMarchSettings.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>
#include <type_traits>

namespace
{
using namespace tetmarch;

constexpr int Composite = 0; // among BlendWords
constexpr int Isosurface = 5;

std::string Quote(const std::string& text)
{
  const bool plain =
    !text.empty() && text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                            "0123456789_./-+,:@%") == std::string::npos;
  if (plain)
  {
    return text;
  }
  std::string quoted = "'";
  for (const char c : text)
  {
    quoted += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return quoted + "'";
}

class Command
{
public:
  explicit Command(std::string text)
    : Text(std::move(text))
  {
  }

  void Flag(const char* name) { this->Text += std::string(" \\\n  ") + name; }
  void Add(const char* name, const std::string& value)
  {
    this->Flag(name);
    this->Text += (value[0] == '-' ? "=" : " ") + Quote(value);
  }
  const std::string& Get() const { return this->Text; }

private:
  std::string Text;
};

void AddData(const DataState& data, Command& command)
{
  if (!data.Array.empty())
  {
    command.Add("--array", data.Array);
    command.Add("--association", data.Association == 1 ? "cells" : "points");
    command.Add("--component", data.Component < 0 ? "magnitude" : std::to_string(data.Component));
  }
  if (data.TimeStep >= 0)
  {
    command.Add("--time-step", std::to_string(data.TimeStep));
  }
  if (data.Nearest)
  {
    command.Add("--interpolation", "nearest");
  }
  if (!data.Surface.empty())
  {
    command.Add("--surface", data.Surface);
  }
}

void AddFunctions(const ViewState& state, Command& command)
{
  command.Add("--preset", "/dev/stdin");
  command.Add("--unit-distance", ToText(state.Functions.UnitDistance));
  command.Add(
    "--opacity-law", state.Functions.StructuredOpacityLaw ? "structured" : "unstructured");
  if (state.Effects.GradientOpacity && state.BlendMode == Composite)
  {
    std::string points;
    for (const auto& point : state.Functions.GradientOpacity)
    {
      points += (points.empty() ? "" : ",") + ToText(point[0]) + "," + ToText(point[1]);
    }
    command.Add("--gradient-opacity", points);
  }
  if (state.Settings.DrawNanCells)
  {
    command.Add("--nan", ToList(state.Functions.NanColor));
  }
}

bool IsLit(const ViewState& state)
{
  return state.Effects.Shading && (state.BlendMode == Composite || state.BlendMode == Isosurface);
}

/// tetmarch-render refuses options that change nothing: light in modes of blending that have none,
/// and what belongs to shadows that are not cast.
bool Changes(const ViewState& state, const SettingNames& names)
{
  const std::string_view option = names.Option;
  const EffectState& effects = state.Effects;
  const int preset = state.Settings.LightPreset;
  const bool shadows = state.Settings.ShadowMethod != 0 ||
                       preset == vtkTetMarchSettings::LIGHT_SUN ||
                       (effects.Scattering && effects.ScatteringStrength > 0.0);
  const bool occlusion = state.Settings.AmbientOcclusion ||
                         preset == vtkTetMarchSettings::LIGHT_STUDIO ||
                         preset == vtkTetMarchSettings::LIGHT_SUN;
  if (option == "--light-preset")
  {
    return preset != vtkTetMarchSettings::LIGHT_OF_SCENE && IsLit(state);
  }
  if (option.empty() || (names.OfLight && !(effects.Shading && state.BlendMode == Composite)))
  {
    return false;
  }
  return option == "--frame-time"        ? state.Settings.FrameTimeBudget > 0.0
         : option == "--occlusion"       ? occlusion
         : option == "--reach"           ? shadows
         : option == "--opaque-shadows"  ? shadows && !state.Data.Surface.empty()
         : option == "--light-tolerance" ? state.Settings.LightTolerance > 0.0
         : option == "--light-through-cuts"
           ? (shadows || occlusion) && (state.Cuts.Clip || state.Cuts.Crop)
           : true;
}

struct SettingWriter
{
  const ViewState& State;
  Command& To;

  template <typename Value>
  void operator()(const SettingNames& names, Value value)
  {
    if (!Changes(this->State, names))
    {
      return;
    }
    if constexpr (!std::is_same_v<Value, bool>)
    {
      this->To.Add(names.Option, ToText(value));
    }
    else if (value)
    {
      this->To.Flag(names.Option);
    }
  }
  template <typename Words>
  void Choice(const SettingNames& names, int number, const Words& words)
  {
    if (Changes(this->State, names))
    {
      this->To.Add(names.Option, words.at(number));
    }
  }
};

void AddLight(const ViewState& state, Command& command)
{
  const EffectState& effects = state.Effects;
  if (!IsLit(state))
  {
    return;
  }
  if (state.Settings.LightPreset == vtkTetMarchSettings::LIGHT_OF_SCENE)
  {
    command.Add("--light", (effects.Headlight ? "headlight" : ToList(effects.LightFrom)) + "," +
                             ToText(effects.Intensity));
    command.Add("--ambient", ToText(effects.Ambient));
    command.Add("--diffuse", ToText(effects.Diffuse));
    command.Add("--specular", ToText(effects.Specular));
    command.Add("--specular-power", ToText(effects.SpecularPower));
  }
  if (state.BlendMode == Composite && effects.Scattering)
  {
    command.Add("--scattering", ToText(effects.ScatteringStrength));
  }
}

void AddView(const ViewState& state, Command& command)
{
  const CameraState& camera = state.Camera;
  command.Add("--camera", ToList(camera.Position) + "," + ToList(camera.FocalPoint) + "," +
                            ToList(camera.ViewUp) + "," + ToText(camera.ViewAngle));
  if (camera.Parallel)
  {
    command.Add("--parallel-scale", ToText(camera.ParallelScale));
  }
  if (state.Cuts.Clip)
  {
    command.Add("--clip", ToList(state.Cuts.Origin) + "," + ToList(state.Cuts.Normal));
  }
  if (state.Cuts.Crop)
  {
    command.Add("--crop", ToList(state.Cuts.Box));
  }
  if (state.BlendMode == Isosurface)
  {
    command.Add("--isovalues", ToList(state.IsoValues));
  }
  else
  {
    command.Add("--blend", BlendWords.at(state.BlendMode));
  }
  command.Add("--background", ToList(state.Background));
  command.Add("--size", std::to_string(state.Size[0]) + "x" + std::to_string(state.Size[1]));
}

/// What no option says.
std::string ListUnsaid(const ViewState& state)
{
  std::string text;
  const auto& colors = state.Functions.Color;
  if (std::any_of(colors.begin(), colors.end(),
        [](const std::array<double, 6>& point) { return point[4] != 0.5 || point[5] != 0.0; }))
  {
    text += "# A preset has no midpoints and sharpness of colours, so they are left out.\n";
  }
  return text;
}
} // namespace

namespace tetmarch
{

std::string WritePreset(const FunctionState& functions)
{
  nlohmann::ordered_json preset;
  preset["Name"] = "tetmarch-view";
  preset["ColorSpace"] = ColorSpaceWords.at(functions.ColorSpace);
  preset["HSVWrap"] = functions.HSVWrap;
  preset["UseLogScale"] = functions.LogScale;
  std::vector<double> colors;
  for (const auto& point : functions.Color)
  {
    colors.insert(colors.end(), point.begin(), point.begin() + 4);
  }
  preset["RGBPoints"] = colors;
  std::vector<double> opacities;
  for (const auto& point : functions.Opacity)
  {
    opacities.insert(opacities.end(), point.begin(), point.end());
  }
  preset["Points"] = opacities;
  preset["NanColor"] = { functions.NanColor[0], functions.NanColor[1], functions.NanColor[2] };
  return nlohmann::ordered_json::array({ preset }).dump();
}

std::string WriteCommand(const ViewState& state, const std::string& output)
{
  Command command(ListUnsaid(state) + "tetmarch-render " + Quote(state.Data.File));
  AddData(state.Data, command);
  AddFunctions(state, command);
  VisitSettings(SettingWriter{ state, command }, state.Settings);
  AddLight(state, command);
  AddView(state, command);
  command.Add("--output", output);
  return command.Get() + " <<'END'\n" + WritePreset(state.Functions) + "\nEND\n";
}

} // namespace tetmarch
