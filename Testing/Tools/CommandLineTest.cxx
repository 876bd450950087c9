// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What tetmarch-render understands of its arguments.
#include "CommandLineErrors.h"

#include "OptionTable.h"

#include "vtkTetMarchFirstPicture.h"

#include <regex>

TEST(CommandLine, Defaults)
{
  const CommandLine c = ParseCommandLine({ "some/folder/mesh.part.vtu" });
  EXPECT_EQ(c.Input, "some/folder/mesh.part.vtu");
  EXPECT_EQ(c.Output, "mesh.part.png");
  EXPECT_EQ(c.Size, (std::array<int, 2>{ { 1024, 768 } }));
  EXPECT_EQ(c.Frames, 0);
  EXPECT_FALSE(c.Nearest || c.Compare || c.Raw.AreGiven());
  EXPECT_EQ(c.Settings->GetAccuracyLevel(), 1);
  EXPECT_EQ(c.Settings->GetViewMode(), 0);
  EXPECT_EQ(c.Settings->GetErrorTolerance(), 1.0 / 255.0);
  EXPECT_FALSE(c.TimeStep || c.Range || c.UnitDistance || c.Camera || c.ParallelScale);
  EXPECT_EQ(c.ArrayAssociation, vtkTetMarchFirstPicture::ANY);
  EXPECT_EQ(c.Settings->GetFrameTimeBudget(), 0.0);
  EXPECT_EQ(c.Settings->GetErrorBudget(), 0.0);
  EXPECT_FALSE(c.Light.Shade);
  EXPECT_TRUE(c.Light.Lights.empty());
  EXPECT_EQ(c.Settings->GetShadowMethod(), 0);
  EXPECT_FALSE(c.Settings->GetOpaqueShadows() || c.Settings->GetAmbientOcclusion());
  EXPECT_TRUE(c.Surfaces.empty());
  EXPECT_EQ(c.Settings->GetVolumetricScatteringBlending(), 0.0f);
  EXPECT_EQ(c.Settings->GetGlobalIlluminationReach(), 1.0f);
  EXPECT_FALSE(c.Light.Ambient || c.Light.Diffuse || c.Light.Specular || c.Light.SpecularPower);
  EXPECT_TRUE(c.Stats.empty() && c.Preset.empty() && c.Array.empty());
}

TEST(CommandLine, TakesEveryOption)
{
  const CommandLine c = ParseCommandLine({ "--array", "T", "--output=o=1.png", "--size", "320x200",
    "--preset", "p.json", "--unit-distance", "2.5", "--camera", "-1,2,3,4,5,6,0,0,1,45",
    "--parallel-scale", "1e3", "--background", "0,0.5,1", "--opacity-law", "structured",
    "--association", "cells", "--stats", "s.json", "--frames", "7", "--time-step", "3", "--range",
    "-1,1", "--accuracy", "accurate", "--tolerance", "0.01", "--frame-time", "0.1", "--error=0.02",
    "--compare", "--view", "cells", "--surface", "a.vtp", "--surface=b.vtk", "m.ex2" });
  EXPECT_EQ(c.Input, "m.ex2");
  EXPECT_EQ(c.Array, "T");
  EXPECT_EQ(c.Output, "o=1.png");
  EXPECT_EQ(c.Size, (std::array<int, 2>{ { 320, 200 } }));
  EXPECT_EQ(c.Preset, "p.json");
  EXPECT_EQ(c.UnitDistance, 2.5);
  ASSERT_TRUE(c.Camera);
  EXPECT_EQ(c.Camera->Position, (std::array<double, 3>{ { -1, 2, 3 } }));
  EXPECT_EQ(c.Camera->FocalPoint, (std::array<double, 3>{ { 4, 5, 6 } }));
  EXPECT_EQ(c.Camera->ViewUp, (std::array<double, 3>{ { 0, 0, 1 } }));
  EXPECT_EQ(c.Camera->ViewAngle, 45.0);
  EXPECT_EQ(c.ParallelScale, 1000.0);
  EXPECT_EQ(c.Background, (std::array<double, 3>{ { 0, 0.5, 1 } }));
  EXPECT_EQ(c.Settings->GetOpacityLaw(), vtkTetMarchSettings::STRUCTURED);
  EXPECT_TRUE(c.Given.count("--opacity-law"));
  EXPECT_EQ(c.ArrayAssociation, vtkTetMarchFirstPicture::CELLS);
  EXPECT_EQ(c.Stats, "s.json");
  EXPECT_EQ(c.Frames, 7);
  EXPECT_EQ(c.TimeStep, 3);
  EXPECT_EQ(c.Settings->GetAccuracyLevel(), 2);
  EXPECT_EQ(c.Settings->GetErrorTolerance(), 0.01);
  EXPECT_EQ(c.Settings->GetFrameTimeBudget(), 0.1);
  EXPECT_EQ(c.Settings->GetErrorBudget(), 0.02);
  EXPECT_EQ(c.Settings->GetViewMode(), 2);
  EXPECT_TRUE(c.Compare);
  EXPECT_EQ(c.Range, (std::array<double, 2>{ { -1, 1 } }));
  EXPECT_EQ(c.Surfaces, (std::vector<std::string>{ "a.vtp", "b.vtk" }));
  EXPECT_FALSE(c.Light.Shade);
}

TEST(CommandLine, TakesSamples)
{
  const CommandLine sampled = ParseCommandLine({ "a.vti", "--accuracy", "sampled" });
  EXPECT_EQ(sampled.Settings->GetAccuracyLevel(), 4);
  EXPECT_FALSE(sampled.SampleDistance);
  EXPECT_FALSE(sampled.Jitter);
  const CommandLine distant = ParseCommandLine({ "a.vti", "--sample-distance", "0.5", "--jitter" });
  EXPECT_EQ(distant.Settings->GetAccuracyLevel(), 4);
  EXPECT_EQ(distant.SampleDistance, 0.5);
  EXPECT_TRUE(distant.Jitter);
}

TEST(CommandLine, TakesAnInterpolation)
{
  EXPECT_EQ(ParseCommandLine({ "a.vti", "--interpolation", "nearest" }).Nearest, true);
  EXPECT_EQ(ParseCommandLine({ "a.vti", "--interpolation=linear" }).Nearest, false);
  EXPECT_EQ(
    ParseCommandLine({ "a.vti", "--opacity-law", "unstructured" }).Settings->GetOpacityLaw(),
    vtkTetMarchSettings::UNSTRUCTURED);
}

TEST(CommandLine, TakesWhatARawFileHolds)
{
  const CommandLine c = ParseCommandLine({ "scan.RAW", "--dimensions", "64,32,16", "--type",
    "int16", "--spacing", "1,1,2.5", "--big-endian" });
  EXPECT_EQ(c.Raw.Dimensions, (std::array<int, 3>{ { 64, 32, 16 } }));
  EXPECT_EQ(c.Raw.Type, VTK_SHORT);
  EXPECT_EQ(c.Raw.Spacing, (std::array<double, 3>{ { 1, 1, 2.5 } }));
  EXPECT_TRUE(c.Raw.BigEndian);
  EXPECT_EQ(c.Output, "scan.png");
}

TEST(CommandLine, FindsInTheNameWhatARawFileHolds)
{
  const CommandLine c = ParseCommandLine({ "some/a_b_256x128x64_uint16.raw" });
  EXPECT_EQ(c.Raw.Dimensions, (std::array<int, 3>{ { 256, 128, 64 } }));
  EXPECT_EQ(c.Raw.Type, VTK_UNSIGNED_SHORT);
  EXPECT_FALSE(c.Raw.Spacing || c.Raw.BigEndian);
  const CommandLine other =
    ParseCommandLine({ "a_256x128x64_float32.raw", "--dimensions", "2,3,4", "--type", "double" });
  EXPECT_EQ(other.Raw.Dimensions, (std::array<int, 3>{ { 2, 3, 4 } }));
  EXPECT_EQ(other.Raw.Type, VTK_DOUBLE);
  EXPECT_EQ(ParseCommandLine({ "a_2x3x4_float64.raw" }).Raw.Type, VTK_DOUBLE);
}

TEST(CommandLine, TakesAPixel)
{
  const CommandLine without = ParseCommandLine({ "a.vtu" });
  EXPECT_FALSE(without.Pixel);
  EXPECT_EQ(without.Output, "a.png");
  const CommandLine c =
    ParseCommandLine({ "a.vtu", "--pixel", "319,0", "--size", "320x200", "--pixel-json=p.json" });
  EXPECT_EQ(c.Pixel, (std::array<int, 2>{ { 319, 0 } }));
  EXPECT_EQ(c.PixelJson, "p.json");
  EXPECT_EQ(c.Output, ""); // no picture unless asked for
  EXPECT_EQ(ParseCommandLine({ "a.vtu", "--pixel", "0,5", "--output", "o.png" }).Output, "o.png");
}

TEST(CommandLine, TakesAPage)
{
  const CommandLine c = ParseCommandLine({ "a.vtu", "--html", "P.HTM", "--html-controls=none" });
  EXPECT_EQ(c.Html, "P.HTM");
  EXPECT_FALSE(c.HtmlControls);
  EXPECT_EQ(c.Output, ""); // no picture unless asked for
  EXPECT_TRUE(ParseCommandLine({ "a.vtu", "--html", "p" }).HtmlControls);
}

// By the numbers of vtkTetMarchVolumeMapper::ViewModeType.
TEST(CommandLine, ViewsAreThoseOfTheMapper)
{
  const char* views[] = { "picture", "error", "cells", "lookups", "illumination", "gradients",
    "faces", "coordinates" };
  int mode = 0;
  for (const char* view : views)
  {
    EXPECT_EQ(ParseCommandLine({ "a.vtu", "--view", view }).Settings->GetViewMode(), mode) << view;
    EXPECT_NE(tetmarch::GetHelp().find(view), std::string::npos) << view;
    ++mode;
  }
}

// By the numbers of vtkTetMarchVolumeMapper::BlendModes.
TEST(CommandLine, BlendModesAreThoseOfTheMapper)
{
  EXPECT_EQ(ParseCommandLine({ "a.vtu" }).BlendMode, 0);
  int mode = 0;
  for (const char* name :
    { "composite", "maximum", "minimum", "average", "additive", "isosurface" })
  {
    std::vector<std::string> arguments{ "a.vtu", "--blend", name };
    if (mode == 5)
    {
      arguments.emplace_back("--isovalues=1");
    }
    EXPECT_EQ(ParseCommandLine(arguments).BlendMode, mode) << name;
    EXPECT_NE(tetmarch::GetHelp().find(name), std::string::npos) << name;
    ++mode;
  }
  const CommandLine steep = ParseCommandLine({ "a.vtu", "--gradient-opacity", "0,0.25,10,1" });
  EXPECT_EQ(
    steep.GradientOpacity, (std::vector<std::array<double, 2>>{ { { 0, 0.25 } }, { { 10, 1 } } }));
  const CommandLine surfaces = ParseCommandLine({ "a.vtu", "--isovalues", "1,-2.5,3" });
  EXPECT_EQ(surfaces.IsoValues, (std::vector<double>{ 1, -2.5, 3 }));
  EXPECT_EQ(surfaces.BlendMode, 5);
}

TEST(CommandLine, TakesEveryOptionOfLight)
{
  const CommandLine c = ParseCommandLine({ "a.vtu", "--light", "-1,2,3", "--light=headlight",
    "--light", "0,0,2,0.5", "--light", "headlight,0.25", "--ambient", "0.1", "--diffuse", "0.2",
    "--specular", "0.3", "--specular-power", "40", "--shadows", "rays", "--scattering", "1.5",
    "--reach", "0.6", "--occlusion", "0.7", "--opaque-shadows", "--surface", "s.vtp",
    "--light-tolerance", "0.01", "--light-through-cuts", "--clip", "0,0,0,1,0,0" });
  const auto& light = c.Light;
  ASSERT_EQ(light.Lights.size(), 4u);
  EXPECT_EQ(light.Lights[0].From, (std::array<double, 3>{ { -1, 2, 3 } }));
  EXPECT_EQ(light.Lights[0].Intensity, 1.0);
  EXPECT_FALSE(light.Lights[1].From);
  EXPECT_EQ(light.Lights[1].Intensity, 1.0);
  EXPECT_EQ(light.Lights[2].From, (std::array<double, 3>{ { 0, 0, 2 } }));
  EXPECT_EQ(light.Lights[2].Intensity, 0.5);
  EXPECT_FALSE(light.Lights[3].From);
  EXPECT_EQ(light.Lights[3].Intensity, 0.25);
  EXPECT_EQ(light.Ambient, 0.1);
  EXPECT_EQ(light.Diffuse, 0.2);
  EXPECT_EQ(light.Specular, 0.3);
  EXPECT_EQ(light.SpecularPower, 40.0);
  EXPECT_EQ(c.Settings->GetShadowMethod(), 3);
  EXPECT_EQ(c.Settings->GetVolumetricScatteringBlending(), 1.5f);
  EXPECT_EQ(c.Settings->GetGlobalIlluminationReach(), 0.6f);
  EXPECT_TRUE(c.Settings->GetAmbientOcclusion());
  EXPECT_EQ(c.Settings->GetAmbientOcclusionRadius(), 0.7);
  EXPECT_TRUE(c.Settings->GetOpaqueShadows());
  EXPECT_EQ(c.Settings->GetLightTolerance(), 0.01);
  EXPECT_TRUE(c.Settings->GetLightThroughCuts());
}

// By the numbers of vtkTetMarchVolumeMapper::ShadowMethods.
TEST(CommandLine, ShadowsAreThoseOfTheMapper)
{
  int method = 0;
  for (const char* word : { "off", "automatic", "vertices", "rays" })
  {
    EXPECT_EQ(ParseCommandLine({ "a.vtu", "--shadows", word }).Settings->GetShadowMethod(), method)
      << word;
    ++method;
  }
}

TEST(CommandLine, WhoAsksForLightHasShading)
{
  EXPECT_TRUE(ParseCommandLine({ "a.vtu", "--shade" }).Light.Shade);
  for (const char* option : { "--light=1,0,0", "--ambient=0.3", "--diffuse=0.5", "--specular=0.3",
         "--specular-power=4", "--shadows=off", "--scattering=0", "--occlusion=0.1" })
  {
    EXPECT_TRUE(ParseCommandLine({ "a.vtu", option }).Light.Shade) << option;
  }
}

TEST(CommandLine, FiguresBringTimedFrames)
{
  EXPECT_EQ(ParseCommandLine({ "a.vtu", "--stats", "s.json" }).Frames, 5);
  EXPECT_EQ(ParseCommandLine({ "a.vtu", "--stats", "s.json", "--frames", "0" }).Frames, 0);
}

TEST(CommandLine, NamesAfterTwoDashesAreFiles)
{
  EXPECT_EQ(ParseCommandLine({ "--", "--help" }).Input, "--help");
}

TEST(CommandLine, TakesCuts)
{
  const auto whole = ParseCommandLine({ "a.vtu" }).Cuts;
  EXPECT_TRUE(whole.Planes.empty());
  EXPECT_FALSE(whole.Crop);
  const auto cuts = ParseCommandLine({ "a.vtu", "--clip", "1,2,3,0,0,-1", "--clip=4,5,6,1,0,0",
                                       "--crop=-1,1,2,3,4,5", "--crop-regions", "cross" })
                      .Cuts;
  ASSERT_EQ(cuts.Planes.size(), 2u);
  EXPECT_EQ(cuts.Planes[0].Origin, (std::array<double, 3>{ { 1, 2, 3 } }));
  EXPECT_EQ(cuts.Planes[0].Normal, (std::array<double, 3>{ { 0, 0, -1 } }));
  EXPECT_EQ(cuts.Planes[1].Origin, (std::array<double, 3>{ { 4, 5, 6 } }));
  EXPECT_EQ(cuts.Crop, (std::array<double, 6>{ { -1, 1, 2, 3, 4, 5 } }));
  EXPECT_EQ(cuts.CropRegions, 3);
  const std::string six = "expected 6 finite numbers separated by commas";
  ExpectBadValue("--clip", "1,2,3", six);
  ExpectBadValue("--clip", "1,2,3,0,0,0", "a plane with a normal of 0,0,0 has no sides");
  ExpectBadValue("--crop", "0,1,0,1,0", six);
  ExpectBadValue("--crop", "0,1,1,1,0,1", "of each two numbers the first must be below the second");
  ExpectBadValue(
    "--crop-regions", "middl", "expected middle, fence, inverted-fence, cross or inverted-cross");
}

TEST(CommandLine, HelpNamesEveryOption)
{
  EXPECT_TRUE(ParseCommandLine({ "--help" }).Help);
  EXPECT_TRUE(ParseCommandLine({ "--version" }).Version);
  const std::string help = tetmarch::GetHelp() + "\n";
  for (const auto& entry : tetmarch::GetOptions())
  {
    EXPECT_TRUE(
      std::regex_search(help, std::regex("\n  (--[-a-zA-Z, ]*, )?" + entry.first + "[ \n]")))
      << entry.first;
  }
}
