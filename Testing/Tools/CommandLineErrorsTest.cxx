// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Arguments that tetmarch-render refuses, and what it says of them.
#include "CommandLineErrors.h"

#include <algorithm>

TEST(CommandLine, RefusesWhatItDoesNotKnow)
{
  EXPECT_EQ(GetError({}), "no input file is given");
  EXPECT_EQ(GetError({ "" }), "no input file is given");
  EXPECT_EQ(GetError({ "a.vtu", "b.vtu" }), "more than one input: 'a.vtu' and 'b.vtu'");
  EXPECT_EQ(GetError({ "a.vtu", "--bogus" }), "unknown option '--bogus'");
  EXPECT_EQ(GetError({ "a.vtu", "--bogus=3" }), "unknown option '--bogus'");
  EXPECT_EQ(GetError({ "a.vtu", "-x" }), "unknown option '-x'");
  EXPECT_EQ(GetError({ "a.vtu", "--size" }), "option --size needs a value");
  EXPECT_EQ(GetError({ "a.vtu", "--array", "--size", "3x3" }), "option --array needs a value");
  EXPECT_EQ(GetError({ "a.vtu", "--array=" }), "bad value '' of --array: the value is empty");
}

TEST(CommandLine, RefusesBadSizes)
{
  for (const char* size :
    { "10", "x", "10x", "0x10", "10x0", "-5x5", "1x16385", "10x10x10", "1e2x5", " 10x10", "3.5x2" })
  {
    ExpectBadValue("--size", size, "expected WIDTHxHEIGHT, each from 1 to 16384");
  }
}

TEST(CommandLine, RefusesBadNumbers)
{
  for (const char* number : { "0", "-1", "nan", "inf", "1e999", "3m", "one", "1,2" })
  {
    ExpectBadValue("--unit-distance", number, "expected a number above 0");
    ExpectBadValue("--parallel-scale", number, "expected a number above 0");
  }
  for (const char* number : { "-1", "1.5", "x", "99999999999" })
  {
    ExpectBadValue("--frames", number, "expected a whole number, 0 or more");
    ExpectBadValue("--time-step", number, "expected a whole number, 0 or more");
  }
}

TEST(CommandLine, RefusesBadLists)
{
  const std::string three = "expected 3 finite numbers separated by commas";
  for (const char* list : { "1", "1,1", "1,1,1,1", "1,,1", "1,1,", ",1,1", "a,b,c", "nan,1,1" })
  {
    ExpectBadValue("--background", list, three);
  }
  ExpectBadValue("--background", "0,0,1.01", "expected three numbers from 0 to 1");
  ExpectBadValue("--background", "-0.1,0,1", "expected three numbers from 0 to 1");
  ExpectBadValue("--range", "1", "expected 2 finite numbers separated by commas");
  ExpectBadValue("--range", "2,1", "the first number must be below the second");
  ExpectBadValue("--range", "1,1", "the first number must be below the second");
}

TEST(CommandLine, RefusesBadDescriptionsOfRawFiles)
{
  for (const char* value : { "1", "1,2", "1,2,3,4", "1,2,", "0,1,1", "-1,2,3", "1.5,2,3", "1x2x3",
         "65537,1,1", "1,2,99999999999" })
  {
    ExpectBadValue("--dimensions", value, "expected NX,NY,NZ, three whole numbers from 1 to 65536");
  }
  ExpectBadValue("--type", "uint12",
    "expected uint8, int8, uint16, int16, uint32, int32, uint64, int64, float, double, float32 or "
    "float64");
  ExpectBadValue("--spacing", "1,2", "expected 3 finite numbers separated by commas");
  ExpectBadValue("--spacing", "1,0,2", "expected three numbers above 0");
  ExpectBadValue("--interpolation", "cubic", "expected nearest or linear");
}

TEST(CommandLine, RawFilesNeedADescription)
{
  const std::string why = "'a.raw' holds nothing but values: say what they are by ";
  EXPECT_EQ(GetError({ "a.raw" }), why + "--dimensions NX,NY,NZ and --type TYPE");
  EXPECT_EQ(GetError({ "a.raw", "--type", "uint8" }), why + "--dimensions NX,NY,NZ");
  EXPECT_EQ(GetError({ "a.raw", "--dimensions", "2,2,2" }), why + "--type TYPE");
  EXPECT_EQ(GetError({ "a.raw", "--dimensions", "2,2,2", "--type", "int8" }), "accepted");
  for (const char* name :
    { "a_2x2_uint8.raw", "a_2x2x2.raw", "2x2x2_uint8.raw", "a_2x2x2_uint8_.raw" })
  {
    EXPECT_NE(GetError({ name }).find("holds nothing but values"), std::string::npos) << name;
  }
  EXPECT_EQ(GetError({ "a_2x2x2_uint12.raw" }),
    "the name of 'a_2x2x2_uint12.raw' says that its type is uint12, but expected uint8, int8, "
    "uint16, int16, uint32, int32, uint64, int64, float, double, float32 or float64; --type "
    "overrides the name");
  EXPECT_EQ(GetError({ "a_0x2x2_uint8.raw" }),
    "the name of 'a_0x2x2_uint8.raw' says that its dimensions are 0,2,2, but expected NX,NY,NZ, "
    "three whole numbers from 1 to 65536; --dimensions overrides the name");
  EXPECT_EQ(GetError({ "a_2x2x2_uint12.raw", "--type", "uint16" }), "accepted");
  for (const std::vector<std::string>& options :
    std::vector<std::vector<std::string>>{ { "--dimensions", "2,2,2" }, { "--type", "int8" },
      { "--spacing", "1,1,1" }, { "--big-endian" } })
  {
    std::vector<std::string> arguments{ "a.vti" };
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(GetError(arguments),
      "--dimensions, --type, --spacing and --big-endian tell of .raw files; 'a.vti' says these "
      "things itself");
  }
}

TEST(CommandLine, RefusesBadCameras)
{
  ExpectBadValue("--camera", "1,2,3", "expected 9 or 10 finite numbers separated by commas");
  ExpectBadValue(
    "--camera", "0,0,5,0,0,0,0,1,0,180", "the view angle must be above 0 and below 180 degrees");
  ExpectBadValue(
    "--camera", "0,0,5,0,0,0,0,1,0,0", "the view angle must be above 0 and below 180 degrees");
  const std::string degenerate = "position and focal point coincide, or the view-up vector is zero "
                                 "or parallel to the line of sight";
  ExpectBadValue("--camera", "0,0,5,0,0,5,0,1,0", degenerate);
  ExpectBadValue("--camera", "0,0,5,0,0,0,0,0,0", degenerate);
  ExpectBadValue("--camera", "0,0,5,0,0,0,0,0,2", degenerate);
}

TEST(CommandLine, RefusesBadChoices)
{
  ExpectBadValue("--opacity-law", "linear", "expected unstructured or structured");
  ExpectBadValue("--accuracy", "best", "expected fast, default, accurate, reference or sampled");
  ExpectBadValue("--view", "bound",
    "expected picture, error, cells, lookups, illumination, gradients, faces or coordinates");
  ExpectBadValue(
    "--blend", "slice", "expected composite, maximum, minimum, average, additive or isosurface");
  for (const char* value : { "1", "0,0.5,1", "0,x" })
  {
    ExpectBadValue(
      "--gradient-opacity", value, "expected finite numbers separated by commas, in pairs");
  }
  for (const char* value : { "0,1.5", "-1,0.5" })
  {
    ExpectBadValue(
      "--gradient-opacity", value, "expected magnitudes of 0 or more, and opacities from 0 to 1");
  }
  ExpectBadValue("--isovalues", "1,x", "expected finite numbers separated by commas");
  ExpectBadValue("--shadows", "on", "expected off, automatic, vertices or rays");
  ExpectBadValue("--tolerance", "0.0000001", "expected a number from 1e-6 to 1");
  ExpectBadValue("--error", "1.5", "expected a number from 1e-6 to 1");
  ExpectBadValue("--frame-time", "0", "expected a number above 0");
  ExpectBadValue("--association", "point", "expected points or cells");
  ExpectBadValue("--html-controls", "some", "expected all or none");
}

TEST(CommandLine, RefusesBadLight)
{
  for (const char* number : { "-0.1", "1.01", "nan", "x", "0.1,0.2" })
  {
    for (const char* option :
      { "--ambient", "--diffuse", "--specular", "--reach", "--occlusion", "--light-tolerance" })
    {
      ExpectBadValue(option, number, "expected a number from 0 to 1");
    }
  }
  ExpectBadValue("--scattering", "2.1", "expected a number from 0 to 2");
  ExpectBadValue("--specular-power", "0", "expected a number above 0");
  for (const char* light : { "headlights", "headlight,", "headlight,x", "headlight,1,2" })
  {
    ExpectBadValue("--light", light, "expected headlight or headlight,INTENSITY");
  }
  for (const char* light : { "head", "1,2", "1,2,3,4,5", "1,2,x" })
  {
    ExpectBadValue("--light", light, "expected 3 or 4 finite numbers separated by commas");
  }
  ExpectBadValue("--light", "0,0,0,1", "a light that shines from 0,0,0 has no direction");
  ExpectBadValue("--light", "0,0,1,-1", "the intensity must be 0 or more");
  ExpectBadValue("--light", "headlight,-1", "the intensity must be 0 or more");
}

TEST(CommandLine, RefusesBadPixels)
{
  for (const char* pixel : { "5", "5,", ",5", "5,5,5", "-1,5", "5,-1", "1.5,2", "a,b", "5 ,5" })
  {
    ExpectBadValue("--pixel", pixel, "expected X,Y, two whole numbers, 0 or more");
  }
  const std::string outside =
    "the pixel of --pixel is outside the picture: columns are 0 to 1023, rows 0 to 767";
  EXPECT_EQ(GetError({ "a.vtu", "--pixel", "1024,0" }), outside);
  EXPECT_EQ(GetError({ "a.vtu", "--pixel", "0,768" }), outside);
}

// Options that would be ignored without others, or because of others.
TEST(CommandLine, RefusesWhatWouldBeIgnored)
{
  const std::string shading = " is for --blend composite and isosurface";
  const std::string light = " is for --blend composite";
  const std::string scene = " is for the light of the scene, which --light-preset replaces";
  const std::string shadows =
    " needs shadows: --shadows, --scattering above 0, or --light-preset sun";
  const std::string drawing = " is for a picture, but --list draws none";
  const std::string samples = " is for --accuracy sampled or --sample-distance, which are missing";
  using Words = std::vector<std::string>;
  const struct
  {
    std::string Option;
    Words With;        // others with which it is refused
    std::string Error; // behind the option's name
    Words Better;      // others with which it is accepted
  } cases[] = {
    { "--compare", {}, " adds to the figures of --stats, which is missing", { "--stats=s" } },
    { "--pixel-json=p", {}, " writes the ray of --pixel, which is missing", { "--pixel=1,1" } },
    { "--crop-regions=fence", {}, " chooses among the regions of --crop, which is missing",
      { "--crop=0,1,0,1,0,1" } },
    { "--jitter", {}, samples, { "--accuracy=sampled" } },
    { "--jitter", { "--accuracy=fast" }, samples, { "--sample-distance=1" } },
    { "--sample-distance=1", { "--accuracy=fast" },
      " is for --accuracy sampled, not for another level", { "--accuracy=sampled" } },
    { "--isovalues=1", { "--blend=maximum" }, " are for --blend isosurface, not for another mode",
      { "--blend=isosurface" } },
    { "--blend=isosurface", {}, " isosurface needs --isovalues, which is missing",
      { "--isovalues=1" } },
    { "--gradient-opacity=0,1", { "--blend=additive" }, light, { "--blend=composite" } },
    { "--shade", { "--blend=maximum" }, shading, {} },
    { "--light=1,0,0", { "--blend=minimum" }, shading, {} },
    { "--ambient=1", { "--blend=average" }, shading, { "--isovalues=1" } },
    { "--diffuse=1", { "--blend=average" }, shading, {} },
    { "--specular=1", { "--blend=average" }, shading, {} },
    { "--specular-power=1", { "--blend=average" }, shading, {} },
    { "--light-preset=sun", { "--blend=maximum" }, shading, {} },
    { "--light=1,0,0", { "--light-preset=sun" }, scene, { "--light-preset=scene" } },
    { "--ambient=1", { "--light-preset=studio" }, scene, {} },
    { "--diffuse=1", { "--light-preset=studio" }, scene, {} },
    { "--specular=1", { "--light-preset=headlight" }, scene, {} },
    { "--specular-power=1", { "--light-preset=headlight" }, scene, {} },
    { "--shadows=rays", { "--isovalues=1" }, light, {} },
    { "--scattering=1", { "--blend=maximum" }, light, {} },
    { "--occlusion=1", { "--isovalues=1" }, light, {} },
    { "--reach=0.5", {}, shadows, { "--shadows=automatic" } },
    { "--reach=0.5", { "--light-preset=studio" }, shadows, { "--light-preset=sun" } },
    { "--reach=0.5", { "--shadows=off" }, shadows, { "--scattering=1" } },
    { "--light-tolerance=0.01", { "--isovalues=1" }, light, {} },
    { "--light-through-cuts", { "--clip=0,0,0,1,0,0" },
      " needs shadows or ambient occlusion: --shadows, --scattering above 0, --occlusion, or "
      "--light-preset studio or sun",
      { "--clip=0,0,0,1,0,0", "--occlusion=0.1" } },
    { "--light-through-cuts", { "--light-preset=studio" },
      " is for what --clip or --crop cut away, which are missing",
      { "--light-preset=studio", "--crop=0,1,0,1,0,1" } },
    { "--opaque-shadows", { "--surface=s" }, shadows, { "--surface=s", "--shadows=rays" } },
    { "--opaque-shadows", { "--shadows=rays" }, " are those of --surface, which is missing",
      { "--scattering=1", "--surface=s" } },
    { "--html-controls=none", {}, " chooses the controls of the page of --html, which is missing",
      { "--html=p.html" } },
    { "--html=p.html", { "--list" }, drawing, {} },
    { "--html=p.html", { "--turntable=3" },
      " writes a page, which readers turn themselves, but --turntable draws pictures from all "
      "around",
      { "--time=all" } },
    { "--html=p.html", { "--tile-size=512" },
      " is for a picture in one piece, but --tile-size 512 has it drawn in tiles", {} },
    { "--output=o.png", { "--list" }, drawing, {} },
    { "--stats=s", { "--list" }, drawing, {} },
    { "--frames=1", { "--list" }, drawing, {} },
    { "--pixel=1,1", { "--list" }, drawing, {} },
    { "--time=all", { "--list" }, drawing, {} },
    { "--turntable=3", { "--list" }, drawing, {} },
  };
  const auto errorOf = [](Words options)
  {
    options.emplace_back("a.vtu");
    return GetError(options);
  };
  for (const auto& [option, with, error, better] : cases)
  {
    Words options = with;
    options.push_back(option);
    const std::string expected = option.substr(0, option.find('=')) + error;
    EXPECT_EQ(errorOf(options), expected) << option;
    std::reverse(options.begin(), options.end()); // whatever the order
    EXPECT_EQ(errorOf(options), expected) << option;
    options = better;
    options.push_back(option);
    EXPECT_EQ(errorOf(options), "accepted") << option;
  }
}

TEST(CommandLine, RefusesOtherFormats)
{
  for (const char* name : { "p.png", "p.html.txt", "cube.vtu" })
  {
    ExpectBadValue(
      "--html", name, "pages are written as HTML alone; give a name that ends in .html");
  }
  for (const char* name : { "o.jpg", "o.png.tif", "/tmp/o.PDF", "cube.vtu" })
  {
    ExpectBadValue(
      "--output", name, "pictures are written as PNG alone; give a name that ends in .png");
  }
  for (const char* name : { "o.png", "O.PNG", "o", "-" })
  {
    EXPECT_EQ(ParseCommandLine({ "a.vtu", "--output", name }).Output, name);
  }
  EXPECT_EQ(ParseCommandLine({ "a.vtu", "--output", "/dev/stdout" }).Output, "-");
  EXPECT_EQ(ParseCommandLine({ "a.vtu", "--stats", "/dev/stdout" }).Stats, "-");
}
