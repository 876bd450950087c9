// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionTable.h"

#include "ColorMaps.h"
#include "Failure.h"
#include "OptionParsers.h"
#include "OptionValues.h"
#include "Outputs.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkTetMarchSettings.h"

namespace
{
using namespace tetmarch;
using Words = std::vector<std::string>;

Option Flag(void (*set)(CommandLine&))
{
  return { Option::NONE, {}, [set](CommandLine& c, const std::string&) { set(c); } };
}

Option Value(void (*set)(CommandLine&, const std::string&), const Words& words = {})
{
  return { Option::OTHER, words, set };
}

Option File(void (*set)(CommandLine&, const std::string&))
{
  return { Option::FILE_NAME, {}, set };
}

/// One of some words, by its place in the list.
Option Word(const Words& words, void (*set)(CommandLine&, int place))
{
  return { Option::OTHER, words,
    [words, set](CommandLine& c, const std::string& v) { set(c, ParseWord(v, words)); } };
}

/// Whoever asks for something of light wants it to shine.
LightOptions& LightOf(CommandLine& commandLine)
{
  commandLine.Light.Shade = true;
  return commandLine.Light;
}

template <typename Number>
using Setter = void (vtkTetMarchSettings::*)(Number);

Option SettingWord(const Words& words, Setter<int> set)
{
  return { Option::OTHER, words, [words, set](CommandLine& c, const std::string& v) {
            (c.Settings->*set)(ParseWord(v, words));
          } };
}

Option SettingSwitch(Setter<bool> set)
{
  return { Option::NONE, {},
    [set](CommandLine& c, const std::string&) { (c.Settings->*set)(true); } };
}

template <typename Number>
Option SettingWithin(const char* least, const char* most, Setter<Number> set)
{
  return { Option::OTHER, {}, [least, most, set](CommandLine& c, const std::string& v) {
            (c.Settings->*set)(static_cast<Number>(ParseWithin(v, least, most)));
          } };
}

Option PositiveSetting(Setter<double> set)
{
  return { Option::OTHER, {},
    [set](CommandLine& c, const std::string& v) { (c.Settings->*set)(ParsePositive(v)); } };
}

template <typename Function>
Option AndThen(const Option& option, const Function& then)
{
  return { option.Value, option.Words,
    [option, then](CommandLine& c, const std::string& v)
    {
      option.Set(c, v);
      then(c);
    } };
}

/// The option switches another setting on, too.
Option Also(Setter<bool> other, const Option& option)
{
  return AndThen(option, [other](CommandLine& c) { (c.Settings->*other)(true); });
}

Option Lit(const Option& option)
{
  return AndThen(option, [](CommandLine& c) { LightOf(c); });
}

std::map<std::string, Option> MakeSettingOptions()
{
  return {
#include "SettingOptions.inc"
  };
}

void SetNan(CommandLine& c, const std::string& v)
{
  c.NanColor = ParseNanColor(v);
  c.Settings->DrawNanCellsOn();
}

void SetBackground(CommandLine& c, const std::string& v)
{
  c.Transparent = v == "none";
  if (!c.Transparent)
  {
    c.Background = ParseColor(v);
  }
}

void SetColors(CommandLine& c, const std::string& v)
{
  c.ListColors = v == "list";
  vtkNew<vtkColorTransferFunction> tried;
  if (!c.ListColors && !ApplyColorMap(v, 0.0, 1.0, tried))
  {
    throw UsageError(DescribeUnknownColorMap(v));
  }
  c.Colors = c.ListColors ? "" : v;
}

std::map<std::string, Option> MakeDataOptions()
{
  return {
    { "--array", Value([](CommandLine& c, const std::string& v) { c.Array = v; }) },
    { "--association",
      Word({ "points", "cells" }, [](CommandLine& c, int n) { c.ArrayAssociation = n; }) },
    { "--big-endian", Flag([](CommandLine& c) { c.Raw.BigEndian = true; }) },
    { "--check", Flag([](CommandLine& c) { c.Check = true; }) },
    { "--component",
      Value([](CommandLine& c, const std::string& v) { c.Component = ParseComponent(v); },
        { "magnitude" }) },
    { "--dimensions",
      Value([](CommandLine& c, const std::string& v) { c.Raw.Dimensions = ParseDimensions(v); }) },
    { "--interpolation",
      Word({ "nearest", "linear" }, [](CommandLine& c, int n) { c.Nearest = n == 0; }) },
    { "--list", Flag([](CommandLine& c) { c.List = true; }) },
    { "--spacing",
      Value([](CommandLine& c, const std::string& v) { c.Raw.Spacing = ParseSpacing(v); }) },
    { "--time",
      Value([](CommandLine& c, const std::string& v) { c.Time = ParseTimeRange(v); }, { "all" }) },
    { "--time-step",
      Value([](CommandLine& c, const std::string& v) { c.TimeStep = ParseCount(v); }) },
    { "--type", Value([](CommandLine& c, const std::string& v) { c.Raw.Type = ParseType(v); },
                  { "uint8", "int8", "uint16", "int16", "uint32", "int32", "uint64", "int64",
                    "float", "double" }) },
  };
}

std::map<std::string, Option> MakeTransferFunctionOptions()
{
  Words colors = GetColorMapNames();
  colors.push_back("list");
  return {
    { "--colors", Value(SetColors, colors) },
    { "--gradient-opacity", Value([](CommandLine& c, const std::string& v)
                              { c.GradientOpacity = ParseGradientOpacity(v); }) },
    { "--nan", Value(SetNan) },
    { "--preset", File([](CommandLine& c, const std::string& v) { c.Preset = v; }) },
    { "--range", Value([](CommandLine& c, const std::string& v) { c.Range = ParseRange(v); }) },
    { "--unit-distance",
      Value([](CommandLine& c, const std::string& v) { c.UnitDistance = ParsePositive(v); }) },
  };
}

std::map<std::string, Option> MakeSampleOptions()
{
  return {
    { "--jitter", Flag([](CommandLine& c) { c.Jitter = true; }) },
    { "--sample-distance",
      Value([](CommandLine& c, const std::string& v) { c.SampleDistance = ParsePositive(v); }) },
  };
}

std::map<std::string, Option> MakeLightOptions()
{
  return {
    { "--ambient", Value([](CommandLine& c, const std::string& v)
                     { LightOf(c).Ambient = ParseWithin(v, "0", "1"); }) },
    { "--diffuse", Value([](CommandLine& c, const std::string& v)
                     { LightOf(c).Diffuse = ParseWithin(v, "0", "1"); }) },
    { "--light", Value([](CommandLine& c, const std::string& v)
                   { LightOf(c).Lights.push_back(ParseLight(v)); },
                   { "headlight" }) },
    { "--shade", Flag([](CommandLine& c) { LightOf(c); }) },
    { "--specular", Value([](CommandLine& c, const std::string& v)
                      { LightOf(c).Specular = ParseWithin(v, "0", "1"); }) },
    { "--specular-power", Value([](CommandLine& c, const std::string& v)
                            { LightOf(c).SpecularPower = ParsePositive(v); }) },
  };
}

std::map<std::string, Option> MakeViewOptions()
{
  return {
    { "--axes", Flag([](CommandLine& c) { c.Annotations.Axes = true; }) },
    { "--background", Value(SetBackground, { "none" }) },
    { "--blend", Word({ "composite", "maximum", "minimum", "average", "additive", "isosurface" },
                   [](CommandLine& c, int n) { c.BlendMode = n; }) },
    { "--camera", Value([](CommandLine& c, const std::string& v) { c.Camera = ParseCamera(v); }) },
    { "--clip", Value([](CommandLine& c, const std::string& v)
                  { c.Cuts.Planes.push_back(ParseClippingPlane(v)); }) },
    { "--crop", Value([](CommandLine& c, const std::string& v) { c.Cuts.Crop = ParseCrop(v); }) },
    { "--crop-regions", Word({ "middle", "fence", "inverted-fence", "cross", "inverted-cross" },
                          [](CommandLine& c, int n) { c.Cuts.CropRegions = n; }) },
    { "--isovalues",
      Value([](CommandLine& c, const std::string& v) { c.IsoValues = ParseList(v); }) },
    { "--outline", Flag([](CommandLine& c) { c.Annotations.Outline = true; }) },
    { "--parallel-scale",
      Value([](CommandLine& c, const std::string& v) { c.ParallelScale = ParsePositive(v); }) },
    { "--scalar-bar", Flag([](CommandLine& c) { c.Annotations.ScalarBar = true; }) },
    { "--size", Value([](CommandLine& c, const std::string& v) { c.Size = ParseSize(v); }) },
    { "--surface", File([](CommandLine& c, const std::string& v) { c.Surfaces.push_back(v); }) },
  };
}

std::map<std::string, Option> MakeOutputOptions()
{
  return {
    { "--compare", Flag([](CommandLine& c) { c.Compare = true; }) },
    { "--frames", Value([](CommandLine& c, const std::string& v) { c.Frames = ParseCount(v); }) },
    { "--html", File([](CommandLine& c, const std::string& v) { c.Html = ParsePageName(v); }) },
    { "--html-controls",
      Word({ "all", "none" }, [](CommandLine& c, int n) { c.HtmlControls = n == 0; }) },
    { "--output",
      File([](CommandLine& c, const std::string& v) { c.Output = ParsePictureName(v); }) },
    { "--pixel", Value([](CommandLine& c, const std::string& v) { c.Pixel = ParsePixel(v); }) },
    { "--pixel-json",
      File([](CommandLine& c, const std::string& v) { c.PixelJson = ParseOutputName(v); }) },
    { "--quiet", Flag([](CommandLine& c) { c.Quiet = true; }) },
    { "--stats", File([](CommandLine& c, const std::string& v) { c.Stats = ParseOutputName(v); }) },
    { "--threads", Value([](CommandLine& c, const std::string& v)
                     { c.Threads = ParseWholeWithin(v, 1, 1024); }) },
    { "--tile-size", Value([](CommandLine& c, const std::string& v)
                       { c.TileSize = ParseWholeWithin(v, 1, 16384); }) },
    { "--turntable", Value([](CommandLine& c, const std::string& v)
                       { c.Turntable = ParseWholeWithin(v, 1, 100000); }) },
  };
}
} // namespace

namespace tetmarch
{

const std::map<std::string, Option>& GetOptions()
{
  static const auto options = []()
  {
    std::map<std::string, Option> all;
    for (const auto make : { MakeSettingOptions, MakeDataOptions, MakeTransferFunctionOptions,
           MakeSampleOptions, MakeLightOptions, MakeViewOptions, MakeOutputOptions })
    {
      all.merge(make());
    }
    return all;
  }();
  return options;
}

void SetOption(CommandLine& commandLine, const std::string& name, const std::string& value)
{
  const Option& option = GetOptions().at(name);
  try
  {
    if (value.empty() && option.Value != Option::NONE)
    {
      throw UsageError("the value is empty");
    }
    option.Set(commandLine, value);
  }
  catch (const UsageError& error)
  {
    throw UsageError("bad value '" + value + "' of " + name + ": " + error.what());
  }
}

} // namespace tetmarch
