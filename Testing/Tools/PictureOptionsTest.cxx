// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Options of what is drawn beside the volume, of tiles and of series, and what doesn't go together.
#include "CommandLineErrors.h"

#include "OptionTable.h"
#include "PngFile.h"
#include "Series.h"
#include "Ticks.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

TEST(PictureOptions, AreOffByDefault)
{
  const CommandLine c = ParseCommandLine({ "a.vtu" });
  EXPECT_FALSE(c.List || c.ListColors || c.Quiet || c.Transparent || c.Time || c.TileSize);
  EXPECT_FALSE(c.Annotations.ScalarBar || c.Annotations.Outline || c.Annotations.Axes);
  EXPECT_EQ(c.Turntable, 0);
  EXPECT_EQ(c.Threads, 0);
  EXPECT_EQ(c.Colors, "");
}

TEST(PictureOptions, AreTaken)
{
  const CommandLine c =
    ParseCommandLine({ "a.vtu", "--scalar-bar", "--outline", "--axes", "--background", "none",
      "--tile-size", "512", "--turntable", "36", "--threads=3", "--quiet", "--colors", "viridis" });
  EXPECT_TRUE(c.Quiet && c.Transparent);
  EXPECT_TRUE(ParseCommandLine({ "a.vtu", "--list" }).List);
  EXPECT_TRUE(c.Annotations.ScalarBar && c.Annotations.Outline && c.Annotations.Axes);
  EXPECT_EQ(c.TileSize, 512);
  EXPECT_EQ(c.Turntable, 36);
  EXPECT_EQ(c.Threads, 3);
  EXPECT_EQ(c.Colors, "viridis");
  EXPECT_FALSE(
    ParseCommandLine({ "a.vtu", "--background", "none", "--background=0,0,0" }).Transparent);
  EXPECT_TRUE(ParseCommandLine({ "--colors", "list" }).ListColors);
}

TEST(PictureOptions, TimeIsARange)
{
  const auto all = ParseCommandLine({ "a.ex2", "--time", "all" }).Time;
  ASSERT_TRUE(all);
  EXPECT_EQ(all->First, 0);
  EXPECT_FALSE(all->Last);
  const auto some = ParseCommandLine({ "a.ex2", "--time", "3:7" }).Time;
  ASSERT_TRUE(some);
  EXPECT_EQ(some->First, 3);
  EXPECT_EQ(some->Last, 7);
  EXPECT_EQ(ParseCommandLine({ "a.ex2", "--time=4:4" }).Time->Last, 4);
}

TEST(PictureOptions, BadValuesAreRefused)
{
  for (const char* range : { "3", "7:3", "-1:3", "1:", ":2", "1:2:3", "some", "1.5:2" })
  {
    ExpectBadValue(
      "--time", range, "expected all or FROM:TO, two time steps, the first not after the second");
  }
  for (const char* number : { "0", "-1", "1.5", "x", "99999999999" })
  {
    ExpectBadValue("--turntable", number, "expected a whole number from 1 to 100000");
    ExpectBadValue("--threads", number, "expected a whole number from 1 to 1024");
    ExpectBadValue("--tile-size", number, "expected a whole number from 1 to 16384");
  }
  ExpectBadValue("--background", "no", "expected 3 finite numbers separated by commas");
  EXPECT_NE(GetError({ "a.vtu", "--colors", "jet" }).find("no colour map 'jet'; known are Viridis"),
    std::string::npos);
  EXPECT_EQ(GetError({ "a.vtu", "--axes=on" }), "option --axes has no value");
}

TEST(PictureOptions, WhatDoesNotGoTogetherIsRefused)
{
  EXPECT_EQ(GetError({ "a.vtu", "--turntable", "9", "--stats", "s.json" }),
    "--stats is for one picture, but --turntable draws a series of them");
  EXPECT_EQ(GetError({ "a.vtu", "--time", "all", "--pixel", "1,1" }),
    "--pixel is for one picture, but --time draws a series of them");
  EXPECT_EQ(GetError({ "a.vtu", "--scalar-bar", "--view", "cells" }),
    "--scalar-bar tells which scalar has which colour, but --view shows other colours than those "
    "of scalars");
}

TEST(PictureOptions, LargePicturesAreDrawnInTilesUnlessAFrameIsLookedAtAsAWhole)
{
  using tetmarch::GetLargestTile;
  EXPECT_EQ(GetLargestTile(ParseCommandLine({ "a.vtu", "--size", "16384x16384" })), 4096);
  EXPECT_EQ(GetLargestTile(ParseCommandLine({ "a.vtu", "--tile-size", "100" })), 100);
  for (const char* option : { "--frames=3", "--stats=s.json", "--pixel=1,2", "--frame-time=1",
         "--view=cells", "--view=error", "--view=lookups" })
  {
    EXPECT_EQ(GetLargestTile(ParseCommandLine({ "a.vtu", "--size", "5000x50", option })), 16384)
      << option;
    EXPECT_NE(GetError({ "a.vtu", "--size", "60x40", "--tile-size", "50", option }), "accepted");
    EXPECT_EQ(GetError({ "a.vtu", "--size", "60x40", "--tile-size", "60", option }), "accepted");
  }
}

TEST(PictureOptions, FramesHaveNumbers)
{
  using tetmarch::GetFrameName;
  EXPECT_EQ(GetFrameName("a/b.png", 7, 10), "a/b_0007.png");
  EXPECT_EQ(GetFrameName("b.c.png", 0, 1), "b.c_0000.png");
  EXPECT_EQ(GetFrameName("b", 9999, 10000), "b_9999");
  EXPECT_EQ(GetFrameName("b.png", 1, 10001), "b_00001.png");
}

TEST(PictureOptions, TheCompletionHasAllOfTheTable)
{
  std::ifstream file(TETMARCH_COMPLETION);
  std::stringstream all;
  all << file.rdbuf();
  const std::string text = all.str();
  const std::regex anOption("--[a-z-]+");
  std::smatch list;
  ASSERT_TRUE(std::regex_search(text, list, std::regex("_options=\"([^\"]*)\"")));
  const std::string names = list[1];
  const std::set<std::string> listed{
    std::sregex_token_iterator(names.begin(), names.end(), anOption), std::sregex_token_iterator()
  };
  std::set<std::string> expected{ "--help", "--version" };
  for (const auto& [name, option] : tetmarch::GetOptions())
  {
    expected.insert(name);
    EXPECT_EQ(std::regex_search(
                text, std::regex("\n *(--[a-z-]+ \\| )*" + name + "( \\| --[a-z-]+)*\\) *;;")),
      option.Value == tetmarch::Option::NONE)
      << name;
    EXPECT_EQ(std::regex_search(text,
                std::regex("\n *(--[a-z-]+ \\| )*" + name + "( \\| --[a-z-]+)*\\)\n *mapfile")),
      option.Value == tetmarch::Option::FILE_NAME)
      << name;
    std::string words;
    for (const std::string& word : option.Words)
    {
      words += " " + word;
    }
    if (name != "--colors" && !words.empty()) // those are asked from the program
    {
      EXPECT_NE(text.find("    " + name + ") printf '%s\\n'" + words + " ;;\n"), std::string::npos)
        << name;
    }
  }
  EXPECT_EQ(listed, expected);
}

TEST(Ticks, AreRoundNumbers)
{
  const auto labels = [](double least, double most, int atMost)
  {
    std::string text;
    for (const tetmarch::Tick& tick : tetmarch::MakeTicks(least, most, atMost))
    {
      text += tick.Label + " ";
    }
    return text;
  };
  EXPECT_EQ(labels(0, 1, 6), "0 0.2 0.4 0.6 0.8 1 ");
  EXPECT_EQ(labels(0, 1, 5), "0 0.5 1 ");
  EXPECT_EQ(labels(-0.3, 0.3, 7), "-0.3 -0.2 -0.1 0 0.1 0.2 0.3 ");
  EXPECT_EQ(labels(293.15, 913.15, 8), "300 400 500 600 700 800 900 ");
  EXPECT_EQ(labels(1e-7, 3.1e-7, 4), "1e-07 2e-07 3e-07 ");
  EXPECT_EQ(labels(1000000.2, 1000001.4, 7), "1000000.2 1000000.4 1000000.6 1000000.8 1000001 "
                                             "1000001.2 1000001.4 ");
  EXPECT_EQ(labels(1e9, 1e9 + 1.2, 4), "1000000000 1000000000.5 1000000001 ");
  EXPECT_EQ(labels(101325.00001, 101325.00003, 3), "101325.00001 101325.00002 101325.00003 ");
  EXPECT_EQ(labels(1.0, 1.0 + 6e-13, 4), "1 1.0000000000002 1.0000000000004 1.0000000000006 ");
  EXPECT_EQ(labels(-5e300, 5e300, 3), "-5e+300 0 5e+300 ");
  EXPECT_EQ(labels(1, 1, 5), "");
  EXPECT_EQ(labels(2, 1, 5), "");
  EXPECT_EQ(labels(0, 1, 0), "");
}

TEST(PngFile, ColoursAreThoseOfOpaqueThings)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const unsigned char drawn[4][4] = { { 0, 0, 0, 0 }, { 51, 102, 0, 102 }, { 1, 2, 3, 3 },
    { 200, 100, 50, 255 } };
  const unsigned char written[4][4] = { { 0, 0, 0, 0 }, { 128, 255, 0, 102 }, { 85, 170, 255, 3 },
    { 200, 100, 50, 255 } };
  auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::copy(&drawn[0][0], &drawn[0][0] + 16, pixels);
  tetmarch::DivideByOpacity(image);
  EXPECT_TRUE(std::equal(pixels, pixels + 16, &written[0][0]));
}
