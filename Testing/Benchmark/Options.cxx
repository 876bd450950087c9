// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Effects.h"
#include "Failure.h"
#include "Mappers.h"
#include "Numbers.h"
#include "Scene.h"
#include "StructuredFunctions.h"
#include "StructuredMappers.h"

#include <functional>
#include <map>
#include <sstream>

namespace tetmarch::bench
{
namespace
{
using Setter = std::function<void(Options&, const std::string& value)>;

std::vector<std::string> split(const std::string& text)
{
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');)
  {
    words.push_back(word);
  }
  return words;
}

std::vector<std::string> parseNames(
  const std::string& text, const std::function<bool(const std::string&)>& known)
{
  const std::vector<std::string> names = split(text);
  for (const std::string& name : names)
  {
    if (!known(name))
    {
      throw UsageError("there is no '" + name + "'");
    }
  }
  return names;
}

int parseCount(const std::string& text)
{
  const auto number = ParseInteger(text);
  if (!number || *number < 1)
  {
    throw UsageError("expected a whole number, 1 or more");
  }
  return *number;
}

std::array<int, 2> parseSize(const std::string& text)
{
  const auto cross = text.find('x');
  if (cross == std::string::npos)
  {
    throw UsageError("expected WIDTHxHEIGHT");
  }
  return { { parseCount(text.substr(0, cross)), parseCount(text.substr(cross + 1)) } };
}

double parseSeconds(const std::string& text)
{
  const auto number = ParseNumber(text);
  if (!number || !(*number > 0.0))
  {
    throw UsageError("expected a number above 0");
  }
  return *number;
}

Pair parsePair(const std::string& text)
{
  const std::vector<std::string> names = split(text);
  if (names.size() != 3 || !isDataset(names[0]) || !isFunctions(names[1]) || !isMapper(names[2]))
  {
    throw UsageError("expected DATASET,FUNCTIONS,MAPPER");
  }
  return { { names[0], names[1] }, names[2] };
}

bool isOfImages(const Options& options) { return options.Kind == StructuredKind; }

const std::map<std::string, Setter>& settersByName()
{
  static const std::map<std::string, Setter> setters = {
    { "--size", [](Options& o, const std::string& v) { o.Size = parseSize(v); } },
    { "--rounds", [](Options& o, const std::string& v) { o.Rounds = parseCount(v); } },
    { "--frames", [](Options& o, const std::string& v) { o.Frames = parseCount(v); } },
    { "--limit", [](Options& o, const std::string& v) { o.LimitSeconds = parseSeconds(v); } },
    { "--datasets", [](Options& o, const std::string& v)
      { o.Datasets = parseNames(v, isOfImages(o) ? isStructuredVolume : isDataset); } },
    { "--functions", [](Options& o, const std::string& v)
      { o.Functions = parseNames(v, isOfImages(o) ? isStructuredFunctions : isFunctions); } },
    { "--mappers", [](Options& o, const std::string& v)
      { o.Mappers = parseNames(v, isOfImages(o) ? isStructuredMapper : isMapper); } },
    { "--stride", [](Options& o, const std::string& v) { o.Stride = parseCount(v); } },
    { "--effects", [](Options& o, const std::string& v) { o.Effects = parseNames(v, isEffect); } },
    { "--against", [](Options& o, const std::string& v) { o.Against = v; } },
    { "--data", [](Options& o, const std::string& v) { o.Folders.Own = v; } },
    { "--more-data", [](Options& o, const std::string& v) { o.Folders.Others = v; } },
    { "--cache", [](Options& o, const std::string& v) { o.CacheFolder = v; } },
    { "--enough", [](Options& o, const std::string& v) { o.EnoughSeconds = parseSeconds(v); } },
    { "--output", [](Options& o, const std::string& v) { o.JsonFile = v; } },
    { "--markdown", [](Options& o, const std::string& v) { o.MarkdownFile = v; } },
    { "--gpu-report", [](Options& o, const std::string& v) { o.GpuReportFile = v; } },
    { "--worker", [](Options& o, const std::string& v) { o.Worker = parsePair(v); } },
  };
  return setters;
}

using Preset = void (*)(Options& options);

/// What accuracy costs: everything that can be set, over time, against the picture in double
/// precision.
void makeAccuracy(Options& options)
{
  options.Kind = "accuracy";
  options.Rounds = 1;
  options.Frames = 4;
  options.EnoughSeconds = 10.0;
  options.Errors = true;
  options.Datasets = { "golfball", "front1.3m", "bluntfin", "oxygen", "golfball-medium" };
  options.Functions = commonFunctions();
  options.Mappers = { "tetmarch-adaptive-fast", "tetmarch-adaptive", "tetmarch-fast",
    "tetmarch:1/32", "tetmarch", "tetmarch:1/1024", "tetmarch-accurate", "tetmarch-reference",
    "projected", "bunyk-homogeneous", "bunyk-preintegration", "bunyk-partial", "bunyk-linear",
    "zsweep", "resample:64/1", "resample:64/4", "resample:128/1", "resample:128/2",
    "resample:128/4", "resample:256/1", "resample:256/2", "resample:512/1" };
}

/// Whether pictures approach that of the field that a mesh was made from, and how fast, as the mesh
/// is refined.
void makeRefinement(Options& options)
{
  options.Kind = "refinement";
  options.Size = { { 256, 256 } };
  options.Rounds = 1;
  options.Frames = 2;
  options.Errors = true;
  options.Datasets = { "refined:4", "refined:8", "refined:16", "refined:32", "refined:64" };
  options.Functions = { "smooth" };
  options.Mappers = { "tetmarch-reference", "tetmarch", "tetmarch-fast", "projected",
    "bunyk-homogeneous", "bunyk-preintegration", "bunyk-partial", "bunyk-linear", "zsweep" };
}

/// What each effect of light adds to a frame of this mapper.
void makeEffects(Options& options)
{
  options.Kind = "effects";
  options.Frames = 8;
  options.EnoughSeconds = 20.0;
  options.Datasets = { "golfball", "lattice1.3m" };
  options.Mappers = { "tetmarch" };
}

/// Images: every level, and VTK's mappers with ever more samples. Jitter and stored scalars are
/// measured where they matter most, with few samples, since a frame with many takes long.
void makeStructured(Options& options)
{
  options.Kind = StructuredKind;
  options.Rounds = 1;
  options.Frames = 3;
  options.EnoughSeconds = 2.0;
  options.Datasets = { "bonsai", "aneurism", "headsq", "carotid", "marschner-lobb:512" };
  options.Functions = structuredFunctions();
  options.Mappers = { "tetmarch-adaptive-fast", "tetmarch-adaptive", "tetmarch-fast", "tetmarch",
    "tetmarch-accurate", "fixed-point", "gpu:1", "gpu:2", "gpu:4", "gpu:10", "gpu-jitter:1",
    "gpu-jitter:2", "gpu-jitter:4", "gpu-stored:2" };
}

const std::map<std::string, Preset>& presetsByName()
{
  static const std::map<std::string, Preset> presets = { { "accuracy", makeAccuracy },
    { "refinement", makeRefinement }, { "effects", makeEffects },
    { StructuredKind, makeStructured } };
  return presets;
}

void makeQuick(Options& options)
{
  options.Size = { { 64, 64 } };
  options.Rounds = 1;
  options.Frames = 2;
  if (isOfImages(options))
  {
    options.Datasets = { "marschner-lobb:16" };
    return;
  }
  // VTK 9.1's projected tetrahedra draw nothing of a grid with fewer than some 1000 cells.
  options.Datasets = { "lattice:6", "lattice:8" };
}
} // namespace

const std::string StructuredKind = "structured";

Options parseOptions(const std::vector<std::string>& arguments)
{
  Options options;
  options.Folders = { TETMARCH_DATA_FOLDER, TETMARCH_MORE_DATA_FOLDER };
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& name = arguments[i];
    const auto preset = presetsByName().find(name);
    if (i == 0 && preset != presetsByName().end())
    {
      preset->second(options);
      continue;
    }
    if (name == "--help" || name == "-h")
    {
      options.Help = true;
      continue;
    }
    if (name == "--quick")
    {
      makeQuick(options);
      continue;
    }
    if (name == "--errors")
    {
      options.Errors = true;
      continue;
    }
    const auto setter = settersByName().find(name);
    if (setter == settersByName().end())
    {
      throw UsageError("unknown option '" + name + "'");
    }
    if (i + 1 == arguments.size() || arguments[i + 1].empty())
    {
      throw UsageError("option " + name + " needs a value");
    }
    const std::string& value = arguments[++i];
    try
    {
      setter->second(options, value);
    }
    catch (const UsageError& error)
    {
      throw UsageError("bad value '" + value + "' of " + name + ": " + error.what());
    }
  }
  if (!options.GpuReportFile.empty() && options.Mappers == Options().Mappers)
  {
    options.Mappers.insert(
      options.Mappers.begin() + 1, { "tetmarch-compute", "tetmarch-fragment" });
  }
  return options;
}

std::vector<std::string> workerArguments(const Options& options, const Pair& pair)
{
  std::vector<std::string> arguments = { "--worker",
    pair.Shown.Dataset + "," + pair.Shown.Functions + "," + pair.Mapper, "--size",
    std::to_string(options.Size[0]) + "x" + std::to_string(options.Size[1]), "--data",
    options.Folders.Own, "--more-data", options.Folders.Others };
  if (!options.CacheFolder.empty())
  {
    arguments.insert(arguments.end(), { "--cache", options.CacheFolder });
  }
  return arguments;
}
} // namespace tetmarch::bench
