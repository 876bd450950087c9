// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the user asked tetmarch-render to do.
 */
#ifndef tetmarch_CommandLine_h
#define tetmarch_CommandLine_h

#include "CutOptions.h"
#include "LightOptions.h"
#include "RawImage.h"
#include "VolumeData.h"

#include "vtkSmartPointer.h"
#include "vtkTetMarchSettings.h"

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace tetmarch
{

struct CameraOption
{
  std::array<double, 3> Position;
  std::array<double, 3> FocalPoint;
  std::array<double, 3> ViewUp;
  std::optional<double> ViewAngle;
};

/// Time steps from the first to the last, both included.
struct TimeRange
{
  int First = 0;
  std::optional<int> Last; // none: the last of the file
};

struct AnnotationOptions
{
  bool ScalarBar = false;
  bool Outline = false;
  bool Axes = false;
};

struct CommandLine
{
  std::set<std::string> Given; // names of options, with their dashes
  bool Help = false;
  bool Version = false;
  bool List = false;  // the arrays, instead of a picture
  bool Check = false; // what is wrong with the file, instead of a picture
  bool ListColors = false;
  bool Quiet = false; // no progress bar, no notes
  int Threads = 0;    // 0: as many as the libraries take

  /// Settings for the mapper. Their opacity law is used only if --opacity-law was given.
  vtkSmartPointer<vtkTetMarchSettings> Settings = vtkSmartPointer<vtkTetMarchSettings>::New();

  std::string Input;
  RawOptions Raw;               // complete, if Input is a raw file
  std::string Output;           // by default the base name of Input + .png; empty: none
  std::string Html;             // a page; empty: none
  bool HtmlControls = true;     // of the page
  std::string Stats;            // empty: none
  std::string Preset;           // empty: the default transfer function
  std::string Colors;           // a map's name; empty: those of the transfer function
  std::string Array;            // empty: chosen by vtkTetMarchFirstPicture
  int ArrayAssociation = -1;    // as vtkTetMarchFirstPicture::Associations
  std::optional<int> Component; // of the array; -1: the magnitude
  std::optional<int> TimeStep;  // the last one by default
  std::optional<std::array<double, 2>> Range;
  std::vector<double> NanColor; // r, g, b, opacity; empty: cells with NaN are not drawn
  std::vector<std::array<double, 2>> GradientOpacity; // magnitudes and opacities; empty: none
  std::optional<double> UnitDistance;
  std::optional<CameraOption> Camera;
  std::optional<double> ParallelScale;
  std::array<double, 3> Background{ { 0.08, 0.09, 0.12 } };
  bool Transparent = false; // no background
  AnnotationOptions Annotations;
  std::array<int, 2> Size{ { 1024, 768 } };
  std::optional<int> TileSize;   // of a picture in tiles; none: chosen by GetLargestTile()
  std::optional<TimeRange> Time; // a picture of each
  int Turntable = 0;             // pictures all around; 0: one picture
  // Interpolation of these; linear by default, of adaptive meshes nearest.
  std::optional<bool> Nearest;
  std::optional<double> SampleDistance; // of the level Sampled; by default that of the mapper
  bool Jitter = false;                  // of its first samples
  CutOptions Cuts;
  LightOptions Light;
  std::vector<std::string> Surfaces; // files
  int BlendMode = 0;                 // vtkVolumeMapper::COMPOSITE_BLEND
  std::vector<double> IsoValues;
  bool Compare = false;
  std::optional<std::array<int, 2>> Pixel; // column and row from the upper left, whose ray is shown
  std::string PixelJson;                   // empty: none
  int Frames = 0;                          // re-renders to be timed; 5 by default if Stats is given
};

/**
 * Throws UsageError. The arguments are those after the program's name.
 */
CommandLine ParseCommandLine(const std::vector<std::string>& arguments);

/// Of each side, in pixels: a larger picture is drawn in tiles.
int GetLargestTile(const CommandLine& commandLine);

/**
 * What --help prints.
 */
std::string GetHelp();

} // namespace tetmarch

#endif
