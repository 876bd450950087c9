// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionChecks.h"

#include "Failure.h"

#include "vtkVolumeMapper.h"

#include <algorithm>

namespace tetmarch
{

namespace
{

bool ShowsBoundary(int viewMode)
{
  return viewMode == vtkTetMarchSettings::VIEW_BOUNDARY_FACES ||
         viewMode == vtkTetMarchSettings::VIEW_BOUNDARY_COORDINATES;
}

/// What looks at one whole frame, or draws one again; else nullptr.
const char* FindOptionOfOneFrame(const CommandLine& commandLine)
{
  return commandLine.Pixel                                   ? "--pixel"
         : !commandLine.Stats.empty()                        ? "--stats"
         : commandLine.Frames > 0                            ? "--frames"
         : commandLine.Settings->GetFrameTimeBudget() > 0.0  ? "--frame-time"
         : ShowsMeasure(commandLine.Settings->GetViewMode()) ? "--view error, cells or lookups"
                                                             : nullptr;
}

bool IsComposite(const CommandLine& c) { return c.BlendMode == vtkVolumeMapper::COMPOSITE_BLEND; }

bool IsLit(const CommandLine& c)
{
  return IsComposite(c) || c.BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND;
}

bool IsSampled(const CommandLine& c)
{
  return c.Settings->GetAccuracyLevel() == vtkTetMarchSettings::SAMPLED;
}

bool HasShadows(const CommandLine& c)
{
  return c.Settings->GetShadowMethod() != vtkTetMarchSettings::SHADOWS_OFF ||
         c.Settings->GetLightPreset() == vtkTetMarchSettings::LIGHT_SUN ||
         c.Settings->GetVolumetricScatteringBlending() > 0.0f;
}

bool HasShadowsOrOcclusion(const CommandLine& c)
{
  return HasShadows(c) || c.Settings->GetAmbientOcclusion() ||
         c.Settings->GetLightPreset() == vtkTetMarchSettings::LIGHT_STUDIO;
}

bool HasLightOfScene(const CommandLine& c)
{
  return c.Settings->GetLightPreset() == vtkTetMarchSettings::LIGHT_OF_SCENE;
}

bool Draws(const CommandLine& c) { return !c.List; }

/// An option that would be ignored without others.
struct Dependency
{
  const char* Option;
  bool (*IsMet)(const CommandLine&);
  const char* Message; // behind the name of the option
};

constexpr const char* OfDrawing = " is for a picture, but --list draws none";
constexpr const char* OfShading = " is for --blend composite and isosurface";
constexpr const char* OfLight = " is for --blend composite";
constexpr const char* OfScene = " is for the light of the scene, which --light-preset replaces";
constexpr const char* OfShadows =
  " needs shadows: --shadows, --scattering above 0, or --light-preset sun";

const Dependency Dependencies[] = {
  { "--compare", [](const CommandLine& c) { return !c.Stats.empty(); },
    " adds to the figures of --stats, which is missing" },
  { "--pixel-json", [](const CommandLine& c) { return c.Pixel.has_value(); },
    " writes the ray of --pixel, which is missing" },
  { "--crop-regions", [](const CommandLine& c) { return c.Cuts.Crop.has_value(); },
    " chooses among the regions of --crop, which is missing" },
  { "--jitter", IsSampled, " is for --accuracy sampled or --sample-distance, which are missing" },
  { "--sample-distance", IsSampled, " is for --accuracy sampled, not for another level" },
  { "--isovalues",
    [](const CommandLine& c) { return c.BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND; },
    " are for --blend isosurface, not for another mode" },
  { "--blend",
    [](const CommandLine& c)
    { return c.BlendMode != vtkVolumeMapper::ISOSURFACE_BLEND || !c.IsoValues.empty(); },
    " isosurface needs --isovalues, which is missing" },
  { "--gradient-opacity", IsComposite, OfLight },
  { "--shade", IsLit, OfShading },
  { "--light", IsLit, OfShading },
  { "--ambient", IsLit, OfShading },
  { "--diffuse", IsLit, OfShading },
  { "--specular", IsLit, OfShading },
  { "--specular-power", IsLit, OfShading },
  { "--light-preset", IsLit, OfShading },
  { "--light", HasLightOfScene, OfScene },
  { "--ambient", HasLightOfScene, OfScene },
  { "--diffuse", HasLightOfScene, OfScene },
  { "--specular", HasLightOfScene, OfScene },
  { "--specular-power", HasLightOfScene, OfScene },
  { "--shadows", IsComposite, OfLight },
  { "--scattering", IsComposite, OfLight },
  { "--occlusion", IsComposite, OfLight },
  { "--reach", HasShadows, OfShadows },
  { "--light-tolerance", IsComposite, OfLight },
  { "--light-through-cuts", HasShadowsOrOcclusion,
    " needs shadows or ambient occlusion: --shadows, --scattering above 0, --occlusion, or "
    "--light-preset studio or sun" },
  { "--light-through-cuts",
    [](const CommandLine& c) { return c.Cuts.Crop.has_value() || !c.Cuts.Planes.empty(); },
    " is for what --clip or --crop cut away, which are missing" },
  { "--opaque-shadows", HasShadows, OfShadows },
  { "--opaque-shadows", [](const CommandLine& c) { return !c.Surfaces.empty(); },
    " are those of --surface, which is missing" },
  { "--html-controls", [](const CommandLine& c) { return !c.Html.empty(); },
    " chooses the controls of the page of --html, which is missing" },
  { "--html", Draws, OfDrawing },
  { "--html", [](const CommandLine& c) { return c.Turntable == 0; },
    " writes a page, which readers turn themselves, but --turntable draws pictures from all "
    "around" },
  { "--output", Draws, OfDrawing },
  { "--stats", Draws, OfDrawing },
  { "--frames", Draws, OfDrawing },
  { "--pixel", Draws, OfDrawing },
  { "--time", Draws, OfDrawing },
  { "--turntable", Draws, OfDrawing },
};

void CheckDependencies(const CommandLine& commandLine)
{
  for (const Dependency& dependency : Dependencies)
  {
    if (commandLine.Given.count(dependency.Option) && !dependency.IsMet(commandLine))
    {
      throw UsageError(std::string(dependency.Option) + dependency.Message);
    }
  }
}

void CheckPixel(const CommandLine& commandLine)
{
  const auto& [width, height] = commandLine.Size;
  if (commandLine.Pixel && ((*commandLine.Pixel)[0] >= width || (*commandLine.Pixel)[1] >= height))
  {
    throw UsageError("the pixel of --pixel is outside the picture: columns are 0 to " +
                     std::to_string(width - 1) + ", rows 0 to " + std::to_string(height - 1));
  }
}

void CheckSeries(const CommandLine& commandLine)
{
  const char* series = commandLine.Time            ? "--time"
                       : commandLine.Turntable > 0 ? "--turntable"
                                                   : nullptr;
  if (commandLine.Time && commandLine.TimeStep)
  {
    throw UsageError("--time and --time-step both choose time steps; give one of them");
  }
  const char* ofOne = FindOptionOfOneFrame(commandLine);
  if (series && ofOne)
  {
    throw UsageError(
      std::string(ofOne) + " is for one picture, but " + series + " draws a series of them");
  }
}

/// What needs the picture in one piece; else nullptr.
const char* FindOptionOfOnePiece(const CommandLine& commandLine)
{
  return commandLine.Html.empty() ? FindOptionOfOneFrame(commandLine) : "--html";
}

void CheckTiles(const CommandLine& commandLine)
{
  const char* ofOne = FindOptionOfOnePiece(commandLine);
  const auto& [width, height] = commandLine.Size;
  if (ofOne && std::max(width, height) > GetLargestTile(commandLine))
  {
    throw UsageError(std::string(ofOne) + " is for a picture in one piece, but --tile-size " +
                     std::to_string(*commandLine.TileSize) + " has it drawn in tiles");
  }
}

/// What a picture of several blocks has not, that are drawn one over the other; else nullptr.
const char* FindOptionOfOneBlock(const CommandLine& commandLine)
{
  const int blend = commandLine.BlendMode;
  return commandLine.Pixel                                   ? "--pixel"
         : commandLine.Compare                               ? "--compare"
         : ShowsMeasure(commandLine.Settings->GetViewMode()) ? "--view error, cells or lookups"
         : blend != vtkVolumeMapper::COMPOSITE_BLEND && blend != vtkVolumeMapper::ISOSURFACE_BLEND
           ? "--blend other than composite or isosurface"
           : nullptr;
}

} // namespace

int GetLargestTile(const CommandLine& commandLine)
{
  constexpr int usual = 4096; // some 300 MB of llvmpipe's memory, and within every GL's limits
  constexpr int unlimited = 16384;
  return commandLine.TileSize.value_or(FindOptionOfOnePiece(commandLine) ? unlimited : usual);
}

bool ShowsMeasure(int viewMode)
{
  return viewMode == vtkTetMarchSettings::VIEW_ERROR_BOUND ||
         viewMode == vtkTetMarchSettings::VIEW_CELLS ||
         viewMode == vtkTetMarchSettings::VIEW_LOOKUPS;
}

void CheckOptions(const CommandLine& commandLine)
{
  CheckDependencies(commandLine);
  if (commandLine.Annotations.ScalarBar &&
      commandLine.Settings->GetViewMode() != vtkTetMarchSettings::VIEW_PICTURE)
  {
    throw UsageError("--scalar-bar tells which scalar has which colour, but --view shows other "
                     "colours than those of scalars");
  }
  CheckPixel(commandLine);
  CheckSeries(commandLine);
  CheckTiles(commandLine);
}

void CheckOptionsOfData(const CommandLine& commandLine, const VolumeData& data)
{
  const std::string input = "'" + commandLine.Input + "'";
  if (!data.Structured && !data.Adaptive && commandLine.Nearest)
  {
    throw Failure("--interpolation is for images, rectilinear grids and adaptive meshes, but " +
                  input + " is drawn as an unstructured grid");
  }
  if (data.Structured && commandLine.Settings->GetGeometryTolerance() > 0.0)
  {
    throw Failure("--geometry-tolerance is for meshes of curved cells, but " + input +
                  " has images or rectilinear grids");
  }
  if (!data.Structured && IsSampled(commandLine))
  {
    throw Failure("--accuracy sampled and --sample-distance are for images and rectilinear grids, "
                  "but " +
                  input + " is drawn as an unstructured grid");
  }
  if (data.Structured && ShowsBoundary(commandLine.Settings->GetViewMode()))
  {
    throw Failure("--view faces and --view coordinates show the boundary of an unstructured grid, "
                  "but " +
                  input + " has images or rectilinear grids");
  }
  const char* ofOne = FindOptionOfOneBlock(commandLine);
  if (data.Structured && data.Blocks.size() > 1 && ofOne)
  {
    throw Failure(std::string(ofOne) + " is for one image or rectilinear grid, but " + input +
                  " has " + std::to_string(data.Blocks.size()) +
                  ", which are drawn one over the other");
  }
}

} // namespace tetmarch
