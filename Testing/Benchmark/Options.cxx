// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Failure.h"
#include "Mappers.h"
#include "Numbers.h"
#include "Scene.h"

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
  if (names.size() != 2 || !isDataset(names[0]) || !isMapper(names[1]))
  {
    throw UsageError("expected DATASET,MAPPER");
  }
  return { names[0], names[1] };
}

const std::map<std::string, Setter>& settersByName()
{
  static const std::map<std::string, Setter> setters = {
    { "--size", [](Options& o, const std::string& v) { o.Size = parseSize(v); } },
    { "--rounds", [](Options& o, const std::string& v) { o.Rounds = parseCount(v); } },
    { "--frames", [](Options& o, const std::string& v) { o.Frames = parseCount(v); } },
    { "--limit", [](Options& o, const std::string& v) { o.LimitSeconds = parseSeconds(v); } },
    { "--datasets",
      [](Options& o, const std::string& v) { o.Datasets = parseNames(v, isDataset); } },
    { "--mappers", [](Options& o, const std::string& v) { o.Mappers = parseNames(v, isMapper); } },
    { "--data", [](Options& o, const std::string& v) { o.DataFolder = v; } },
    { "--output", [](Options& o, const std::string& v) { o.JsonFile = v; } },
    { "--markdown", [](Options& o, const std::string& v) { o.MarkdownFile = v; } },
    { "--worker", [](Options& o, const std::string& v) { o.Worker = parsePair(v); } },
  };
  return setters;
}

void makeQuick(Options& options)
{
  options.Size = { { 64, 64 } };
  options.Rounds = 1;
  options.Frames = 2;
  // VTK 9.1's projected tetrahedra draw nothing of a grid with fewer than some 1000 cells.
  options.Datasets = { "lattice:6", "lattice:8" };
}
} // namespace

Options parseOptions(const std::vector<std::string>& arguments)
{
  Options options;
  options.DataFolder = TETMARCH_DATA_FOLDER;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& name = arguments[i];
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
  return options;
}

std::vector<std::string> workerArguments(const Options& options, const Pair& pair)
{
  return { "--worker", pair.Dataset + "," + pair.Mapper, "--size",
    std::to_string(options.Size[0]) + "x" + std::to_string(options.Size[1]), "--data",
    options.DataFolder };
}

std::string helpText()
{
  return R"(Usage: tetmarch-bench [options]

Times vtkTetMarchVolumeMapper beside VTK's own mappers for unstructured grids, one frame each in turn,
prints a table in Markdown and, if asked, writes every figure as JSON.

  --datasets A,B,...        of lattice162k, lattice1.3m, lattice6m, golfball, lattice:N (6 N^3 tetrahedra)
                            (default: the first four)
  --mappers A,B,...         of tetmarch, tetmarch-fast, tetmarch-accurate, tetmarch-reference, projected,
                            bunyk (default: tetmarch, projected, bunyk)
  --size WxH                of the window (default: 512x512)
  --rounds N                how often each mapper starts in a new process (default: 2)
  --frames N                frames of a mapper in a round, after the first (default: 5)
  --limit SECONDS           a mapper that takes longer for a frame, or five times as long to get ready or
                            for its first frame, is left out from there on (default: 60)
  --quick                   tiny lattices, a small window and few frames; options after it still count
  --data FOLDER             where golfball_small.vtu lies (default: Data/ of the sources)
  --output FILE.json
  --markdown FILE.md        the table that is printed
  --help

Environment: TETMARCH_GL=egl|osmesa as for tetmarch-render; LP_NUM_THREADS for Mesa's llvmpipe.
)";
}
} // namespace tetmarch::bench
