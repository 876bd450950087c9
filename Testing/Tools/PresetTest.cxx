// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Failure.h"
#include "TransferFunctionPreset.h"

#include <gtest/gtest.h>

namespace
{
std::string GetError(const std::string& text)
{
  try
  {
    tetmarch::ParsePreset(text, "p.json");
  }
  catch (const tetmarch::Failure& failure)
  {
    return failure.what();
  }
  return "accepted";
}

std::string GetFieldError(const std::string& fields) { return GetError("[{" + fields + "}]"); }

const char* const Colors = R"("RGBPoints": [0, 0, 0, 1,  1, 1, 0, 0])";
} // namespace

TEST(Preset, MalformedTextIsPlacedByLine)
{
  const std::string error = GetError("[\n  {\n    \"Name\" \"x\"\n  }\n]");
  EXPECT_EQ(error.find("preset 'p.json': parse error at line 3, column 14"), 0u) << error;
  EXPECT_NE(GetError("").find("parse error at line 1"), std::string::npos);
}

TEST(Preset, RefusesOtherDocuments)
{
  EXPECT_EQ(GetError("[]"), "preset 'p.json': the array of presets is empty");
  EXPECT_EQ(GetError("[3]"),
    "preset 'p.json': expected an array of presets, each an object with a field RGBPoints");
  EXPECT_EQ(GetError("null"),
    "preset 'p.json': expected an array of presets, each an object with a field RGBPoints");
}

TEST(Preset, NamesTheFieldAtFault)
{
  const std::string p = "preset 'p.json': ";
  EXPECT_EQ(GetFieldError(""), p + "the field RGBPoints is missing or empty");
  EXPECT_EQ(GetFieldError(R"("RGBPoints": [])"), p + "the field RGBPoints is missing or empty");
  EXPECT_EQ(GetFieldError(R"("IndexedColors": [1, 0, 0])"),
    p + "a preset of IndexedColors is for categories and can't colour a volume");
  EXPECT_EQ(GetFieldError(R"("RGBPoints": [0, 1, 1])"),
    p + "RGBPoints must be an array of numbers, 4 for each point");
  EXPECT_EQ(GetFieldError(R"("RGBPoints": "red")"),
    p + "RGBPoints must be an array of numbers, 4 for each point");
  EXPECT_EQ(
    GetFieldError(R"("RGBPoints": [0, 1, "a", 1])"), p + "RGBPoints[2] is \"a\", not a number");
  EXPECT_EQ(GetFieldError(R"("RGBPoints": [1, 0, 0, 0, 0, 1, 1, 1])"),
    p + "RGBPoints[4] is below the point before it; the points must be in ascending order");
  const std::string colors = Colors;
  EXPECT_EQ(
    GetFieldError(colors + R"(, "Points": [0, 1.5, 0.5, 0])"), p + "Points[1] must be from 0 to 1");
  EXPECT_EQ(GetFieldError(colors + R"(, "ColorSpace": "Pantone")"),
    p + "ColorSpace is \"Pantone\"; known are RGB, HSV, Lab, CIELAB, Diverging, Lab/CIEDE2000 and "
        "Step");
  EXPECT_EQ(GetFieldError(colors + R"(, "ColorSpace": 3)").find(p + "ColorSpace is 3;"), 0u);
  EXPECT_EQ(GetFieldError(colors + R"(, "NanColor": [1])"),
    p + "NanColor must be an array of three numbers");
  EXPECT_EQ(GetFieldError(colors + R"(, "UseLogScale": 1)").find(p + "UseLogScale asks for"), 0u);
}

TEST(Preset, MissingFile)
{
  EXPECT_THROW(tetmarch::ReadPreset("/no/such/preset.json"), tetmarch::Failure);
}

TEST(Preset, PointsAreUsedAsTheyAre)
{
  const auto f = tetmarch::ParsePreset(R"([{"Name": "first", "ColorSpace": "Step",
    "RGBPoints": [-2, 0.1, 0.2, 0.3,  6, 0.4, 0.5, 0.6],
    "Points": [-2, 0.25, 0.5, 0,  6, 0.75, 0.5, 0], "NanColor": [0, 1, 0.5], "Creator": "x"},
    {"Name": "second"}])",
    "p.json");
  EXPECT_EQ(f.Color->GetColorSpace(), VTK_CTF_STEP);
  EXPECT_EQ(f.Color->GetRange()[0], -2.0);
  EXPECT_EQ(f.Color->GetRange()[1], 6.0);
  double rgb[3];
  f.Color->GetColor(-2.0, rgb);
  EXPECT_DOUBLE_EQ(rgb[0], 0.1);
  EXPECT_DOUBLE_EQ(rgb[1], 0.2);
  EXPECT_DOUBLE_EQ(rgb[2], 0.3);
  EXPECT_DOUBLE_EQ(f.Opacity->GetValue(2.0), 0.5);
  EXPECT_DOUBLE_EQ(f.Color->GetNanColor()[2], 0.5);
}

TEST(Preset, MidpointAndSharpnessAreKept)
{
  const auto f = tetmarch::ParsePreset(
    std::string("{") + Colors + R"(, "Points": [0, 0, 0.25, 1,  1, 1, 0.5, 0]})", "p.json");
  double node[4];
  f.Opacity->GetNodeValue(0, node);
  EXPECT_EQ(node[2], 0.25); // midpoint
  EXPECT_EQ(node[3], 1.0);  // sharpness; what VTK makes of it is another in 9.6
}

TEST(Preset, RangeStretchesBothFunctions)
{
  const auto f =
    tetmarch::ParsePreset(std::string("[{\"ColorSpace\": \"RGB\", ") + Colors +
                            R"(, "Points": [0, 0, 0.5, 0,  0.5, 1, 0.5, 0,  1, 0, 0.5, 0]}])",
      "p.json", std::array<double, 2>{ { 100.0, 300.0 } });
  EXPECT_EQ(f.Color->GetRange()[0], 100.0);
  EXPECT_EQ(f.Color->GetRange()[1], 300.0);
  EXPECT_DOUBLE_EQ(f.Opacity->GetValue(200.0), 1.0);
  EXPECT_DOUBLE_EQ(f.Opacity->GetValue(150.0), 0.5);
  EXPECT_DOUBLE_EQ(f.Color->GetRedValue(150.0), 0.25);
}

TEST(Preset, WithoutOpacityPointsItRises)
{
  const auto f = tetmarch::ParsePreset(std::string("{") + Colors + "}", "p.json");
  EXPECT_DOUBLE_EQ(f.Opacity->GetValue(0.0), 0.0);
  EXPECT_DOUBLE_EQ(f.Opacity->GetValue(0.75), 0.75);
}

TEST(Preset, EveryColorSpace)
{
  const std::pair<const char*, int> spaces[] = { { "RGB", VTK_CTF_RGB }, { "HSV", VTK_CTF_HSV },
    { "Lab", VTK_CTF_LAB }, { "CIELAB", VTK_CTF_LAB }, { "Diverging", VTK_CTF_DIVERGING },
    { "Lab/CIEDE2000", VTK_CTF_LAB_CIEDE2000 }, { "Step", VTK_CTF_STEP } };
  for (const auto& [name, space] : spaces)
  {
    const auto f = tetmarch::ParsePreset(
      std::string("{\"ColorSpace\": \"") + name + "\", " + Colors + "}", "p.json");
    EXPECT_EQ(f.Color->GetColorSpace(), space) << name;
  }
}

TEST(Preset, LogScale)
{
  const auto f = tetmarch::ParsePreset(
    R"({"UseLogScale": 1, "RGBPoints": [1, 0, 0, 0, 100, 1, 1, 1], "ColorSpace": "RGB"})",
    "p.json");
  EXPECT_NEAR(f.Color->GetRedValue(10.0), 0.5, 1e-12);
}

TEST(Preset, TellsWhetherItHasOpacity)
{
  EXPECT_FALSE(tetmarch::ParsePreset(std::string("{") + Colors + "}", "p").HasOpacityOfItsOwn);
  EXPECT_TRUE(
    tetmarch::ParsePreset(std::string("{") + Colors + R"(, "Points": [0, 0, 0.5, 0]})", "p")
      .HasOpacityOfItsOwn);
}
