// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionChecks.h"

#include "Failure.h"

#include "vtkTetMarchSettings.h"
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
  return commandLine.Pixel                    ? "--pixel"
         : !commandLine.Stats.empty()         ? "--stats"
         : commandLine.Frames > 0             ? "--frames"
         : commandLine.FrameTime > 0.0        ? "--frame-time"
         : ShowsMeasure(commandLine.ViewMode) ? "--view error, cells or lookups"
                                              : nullptr;
}

void CheckPixel(const CommandLine& commandLine)
{
  const auto& [width, height] = commandLine.Size;
  if (!commandLine.Pixel && !commandLine.PixelJson.empty())
  {
    throw UsageError("--pixel-json writes the ray of --pixel, which is missing");
  }
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

void CheckTiles(const CommandLine& commandLine)
{
  const char* ofOne = FindOptionOfOneFrame(commandLine);
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
  return commandLine.Pixel                    ? "--pixel"
         : commandLine.Compare                ? "--compare"
         : ShowsMeasure(commandLine.ViewMode) ? "--view error, cells or lookups"
         : blend != vtkVolumeMapper::COMPOSITE_BLEND && blend != vtkVolumeMapper::ISOSURFACE_BLEND
           ? "--blend other than composite or isosurface"
           : nullptr;
}

} // namespace

int GetLargestTile(const CommandLine& commandLine)
{
  constexpr int usual = 4096; // some 300 MB of llvmpipe's memory, and within every GL's limits
  constexpr int unlimited = 16384;
  return commandLine.TileSize.value_or(FindOptionOfOneFrame(commandLine) ? unlimited : usual);
}

bool ShowsMeasure(int viewMode)
{
  return viewMode == vtkTetMarchSettings::VIEW_ERROR_BOUND ||
         viewMode == vtkTetMarchSettings::VIEW_CELLS ||
         viewMode == vtkTetMarchSettings::VIEW_LOOKUPS;
}

void CheckOptions(const CommandLine& commandLine)
{
  if (commandLine.Compare && commandLine.Stats.empty())
  {
    throw UsageError("--compare adds to the figures of --stats, which is missing");
  }
  if (commandLine.Annotations.ScalarBar &&
      commandLine.ViewMode != vtkTetMarchSettings::VIEW_PICTURE)
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
  if (!data.Structured && commandLine.Nearest)
  {
    throw Failure("--interpolation is for images and rectilinear grids, but " + input +
                  " is drawn as an unstructured grid");
  }
  if (!data.Structured && commandLine.AccuracyLevel == vtkTetMarchSettings::SAMPLED)
  {
    throw Failure("--accuracy sampled and --sample-distance are for images and rectilinear grids, "
                  "but " +
                  input + " is drawn as an unstructured grid");
  }
  if (data.Structured && ShowsBoundary(commandLine.ViewMode))
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
