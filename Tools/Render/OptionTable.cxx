// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionTable.h"

#include "Failure.h"
#include "Numbers.h"
#include "OptionValues.h"

#include <functional>
#include <map>

namespace
{
using namespace tetmarch;
using Setter = std::function<void(CommandLine&, const std::string& value)>;

constexpr int MaximumSize = 16384; // the least that GL 4.5 promises for both viewport and texture

std::array<int, 2> ParseSize(const std::string& value)
{
  const auto x = value.find('x');
  if (x != std::string::npos)
  {
    const auto width = ParseInteger(value.substr(0, x));
    const auto height = ParseInteger(value.substr(x + 1));
    if (width && height && *width >= 1 && *height >= 1 && *width <= MaximumSize &&
        *height <= MaximumSize)
    {
      return { { *width, *height } };
    }
  }
  throw UsageError("expected WIDTHxHEIGHT, each from 1 to " + std::to_string(MaximumSize));
}

std::array<int, 2> ParsePixel(const std::string& value)
{
  const auto comma = value.find(',');
  if (comma != std::string::npos)
  {
    const auto x = ParseInteger(value.substr(0, comma));
    const auto y = ParseInteger(value.substr(comma + 1));
    if (x && y && *x >= 0 && *y >= 0)
    {
      return { { *x, *y } };
    }
  }
  throw UsageError("expected X,Y, two whole numbers, 0 or more");
}

std::array<double, 3> ParseColor(const std::string& value)
{
  const auto rgb = ParseList(value, { 3 });
  for (double channel : rgb)
  {
    if (!(channel >= 0.0 && channel <= 1.0))
    {
      throw UsageError("expected three numbers from 0 to 1");
    }
  }
  return { { rgb[0], rgb[1], rgb[2] } };
}

std::array<double, 2> ParseRange(const std::string& value)
{
  const auto range = ParseList(value, { 2 });
  if (!(range[0] < range[1]))
  {
    throw UsageError("the first number must be below the second");
  }
  return { { range[0], range[1] } };
}

CameraOption ParseCamera(const std::string& value)
{
  const auto n = ParseList(value, { 9, 10 });
  CameraOption camera;
  camera.Position = { { n[0], n[1], n[2] } };
  camera.FocalPoint = { { n[3], n[4], n[5] } };
  camera.ViewUp = { { n[6], n[7], n[8] } };
  const double direction[3] = { n[3] - n[0], n[4] - n[1], n[5] - n[2] };
  const double cross[3] = { direction[1] * n[8] - direction[2] * n[7],
    direction[2] * n[6] - direction[0] * n[8], direction[0] * n[7] - direction[1] * n[6] };
  if (cross[0] == 0.0 && cross[1] == 0.0 && cross[2] == 0.0)
  {
    throw UsageError("position and focal point coincide, or the view-up vector is zero or parallel "
                     "to the line of sight");
  }
  if (n.size() == 10)
  {
    if (!(n[9] > 0.0 && n[9] < 180.0))
    {
      throw UsageError("the view angle must be above 0 and below 180 degrees");
    }
    camera.ViewAngle = n[9];
  }
  return camera;
}

std::vector<double> ParseNanColor(const std::string& value)
{
  auto rgba = ParseList(value, { 3, 4 });
  for (double channel : rgba)
  {
    if (!(channel >= 0.0 && channel <= 1.0))
    {
      throw UsageError("expected three or four numbers from 0 to 1");
    }
  }
  rgba.resize(4, 1.0);
  return rgba;
}

int ParseComponent(const std::string& value)
{
  return value == "magnitude" ? -1 : ParseCount(value);
}

int ParseLevel(const std::string& value)
{
  return ParseWord(value, { "fast", "default", "accurate", "reference", "sampled" });
}

int ParseBlend(const std::string& value)
{
  return ParseWord(
    value, { "composite", "maximum", "minimum", "average", "additive", "isosurface" });
}

int ParseView(const std::string& value)
{
  return ParseWord(value, { "picture", "error", "cells", "lookups", "illumination", "gradients",
                            "faces", "coordinates" });
}

int ParseShadows(const std::string& value)
{
  return ParseWord(value, { "off", "automatic", "vertices", "rays" });
}

const std::map<std::string, Setter>& GetOptionsWithValue()
{
  static const std::map<std::string, Setter> options = {
    { "--accuracy", [](CommandLine& c, const std::string& v) { c.AccuracyLevel = ParseLevel(v); } },
    { "--ambient",
      [](CommandLine& c, const std::string& v) { LightOf(c).Ambient = ParseWithin(v, "0", "1"); } },
    { "--array", [](CommandLine& c, const std::string& v) { c.Array = v; } },
    { "--association",
      [](CommandLine& c, const std::string& v) {
        c.ArrayAssociation = ParseWord(v, { "points", "cells" });
      } },
    { "--background", [](CommandLine& c, const std::string& v) { c.Background = ParseColor(v); } },
    { "--blend", [](CommandLine& c, const std::string& v) { c.BlendMode = ParseBlend(v); } },
    { "--camera", [](CommandLine& c, const std::string& v) { c.Camera = ParseCamera(v); } },
    { "--clip", [](CommandLine& c, const std::string& v)
      { c.Cuts.Planes.push_back(ParseClippingPlane(v)); } },
    { "--component",
      [](CommandLine& c, const std::string& v) { c.Component = ParseComponent(v); } },
    { "--crop", [](CommandLine& c, const std::string& v) { c.Cuts.Crop = ParseCrop(v); } },
    { "--crop-regions",
      [](CommandLine& c, const std::string& v) { c.Cuts.CropRegions = ParseCropRegions(v); } },
    { "--diffuse",
      [](CommandLine& c, const std::string& v) { LightOf(c).Diffuse = ParseWithin(v, "0", "1"); } },
    { "--dimensions",
      [](CommandLine& c, const std::string& v) { c.Raw.Dimensions = ParseDimensions(v); } },
    { "--error",
      [](CommandLine& c, const std::string& v) { c.Error = ParseWithin(v, "1e-6", "1"); } },
    { "--frame-time",
      [](CommandLine& c, const std::string& v) { c.FrameTime = ParsePositive(v); } },
    { "--frames", [](CommandLine& c, const std::string& v) { c.Frames = ParseCount(v); } },
    { "--interpolation", [](CommandLine& c, const std::string& v)
      { c.Nearest = ParseChoice(v, "nearest", "linear"); } },
    { "--isovalues",
      [](CommandLine& c, const std::string& v)
      {
        c.IsoValues = ParseList(v);
        c.BlendMode = ParseBlend("isosurface");
      } },
    { "--nan", [](CommandLine& c, const std::string& v) { c.NanColor = ParseNanColor(v); } },
    { "--light",
      [](CommandLine& c, const std::string& v) { LightOf(c).Lights.push_back(ParseLight(v)); } },
    { "--occlusion", [](CommandLine& c, const std::string& v)
      { LightOf(c).OcclusionRadius = ParseWithin(v, "0", "1"); } },
    { "--opacity-law", [](CommandLine& c, const std::string& v)
      { c.StructuredOpacityLaw = ParseChoice(v, "structured", "unstructured"); } },
    { "--output", [](CommandLine& c, const std::string& v) { c.Output = v; } },
    { "--parallel-scale",
      [](CommandLine& c, const std::string& v) { c.ParallelScale = ParsePositive(v); } },
    { "--pixel", [](CommandLine& c, const std::string& v) { c.Pixel = ParsePixel(v); } },
    { "--pixel-json", [](CommandLine& c, const std::string& v) { c.PixelJson = v; } },
    { "--preset", [](CommandLine& c, const std::string& v) { c.Preset = v; } },
    { "--range", [](CommandLine& c, const std::string& v) { c.Range = ParseRange(v); } },
    { "--reach",
      [](CommandLine& c, const std::string& v) { LightOf(c).Reach = ParseWithin(v, "0", "1"); } },
    { "--sample-distance",
      [](CommandLine& c, const std::string& v)
      {
        c.SampleDistance = ParsePositive(v);
        c.AccuracyLevel = ParseLevel("sampled");
      } },
    { "--scattering", [](CommandLine& c, const std::string& v)
      { LightOf(c).Scattering = ParseWithin(v, "0", "2"); } },
    { "--shadows",
      [](CommandLine& c, const std::string& v) { LightOf(c).ShadowMethod = ParseShadows(v); } },
    { "--size", [](CommandLine& c, const std::string& v) { c.Size = ParseSize(v); } },
    { "--spacing", [](CommandLine& c, const std::string& v) { c.Raw.Spacing = ParseSpacing(v); } },
    { "--specular", [](CommandLine& c, const std::string& v)
      { LightOf(c).Specular = ParseWithin(v, "0", "1"); } },
    { "--specular-power",
      [](CommandLine& c, const std::string& v) { LightOf(c).SpecularPower = ParsePositive(v); } },
    { "--stats", [](CommandLine& c, const std::string& v) { c.Stats = v; } },
    { "--time-step", [](CommandLine& c, const std::string& v) { c.TimeStep = ParseCount(v); } },
    { "--surface", [](CommandLine& c, const std::string& v) { c.Surfaces.push_back(v); } },
    { "--tolerance",
      [](CommandLine& c, const std::string& v) { c.Tolerance = ParseWithin(v, "1e-6", "1"); } },
    { "--type", [](CommandLine& c, const std::string& v) { c.Raw.Type = ParseType(v); } },
    { "--unit-distance",
      [](CommandLine& c, const std::string& v) { c.UnitDistance = ParsePositive(v); } },
    { "--view", [](CommandLine& c, const std::string& v) { c.ViewMode = ParseView(v); } },
  };
  return options;
}
} // namespace

namespace tetmarch
{

LightOptions& LightOf(CommandLine& commandLine)
{
  commandLine.Light.Shade = true;
  return commandLine.Light;
}

bool IsOptionWithValue(const std::string& name) { return GetOptionsWithValue().count(name) > 0; }

void SetOption(CommandLine& commandLine, const std::string& name, const std::string& value)
{
  try
  {
    if (value.empty())
    {
      throw UsageError("the value is empty");
    }
    GetOptionsWithValue().at(name)(commandLine, value);
  }
  catch (const UsageError& error)
  {
    throw UsageError("bad value '" + value + "' of " + name + ": " + error.what());
  }
}

} // namespace tetmarch
