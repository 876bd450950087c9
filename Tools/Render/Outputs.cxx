// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Outputs.h"

#include "Failure.h"
#include "FileReader.h"
#include "FileSeries.h"
#include "OutputFile.h"
#include "Series.h"
#include "StandardOutput.h"

#include <algorithm>
#include <filesystem>
#include <unistd.h>
#include <vector>

namespace
{
using namespace tetmarch;
namespace fs = std::filesystem;

constexpr const char* ToStandardOutput = "-";

struct NamedFile
{
  std::string What;
  std::string Path;
};

/// By other spellings, hard and symbolic links, too. Files that aren't there yet are the same if
/// their names are.
bool AreSame(const std::string& a, const std::string& b)
{
  std::error_code error;
  if (fs::equivalent(a, b, error))
  {
    return true;
  }
  const fs::path whole = fs::weakly_canonical(fs::absolute(a, error), error);
  return !error && whole == fs::weakly_canonical(fs::absolute(b, error), error);
}

std::vector<NamedFile> ListInputs(const CommandLine& commandLine)
{
  std::vector<NamedFile> inputs{ { "the input", commandLine.Input } };
  std::error_code error;
  if (IsSeriesFile(commandLine.Input) && fs::exists(commandLine.Input, error))
  {
    for (const SeriesStep& step : ReadSeries(commandLine.Input).Steps)
    {
      for (const SeriesPart& part : step.Parts)
      {
        inputs.push_back({ "a file of the input", part.Path });
      }
    }
  }
  inputs.push_back({ "the file of --preset", commandLine.Preset });
  for (const std::string& surface : commandLine.Surfaces)
  {
    inputs.push_back({ "the file of --surface", surface });
  }
  return inputs;
}

/// Pictures of a series are numbered: of these the first.
std::vector<NamedFile> ListOutputs(const CommandLine& commandLine)
{
  const bool isSeries = commandLine.Time || commandLine.Turntable > 0;
  const std::string picture = isSeries && !commandLine.Output.empty()
                                ? GetFrameName(commandLine.Output, 0, 1)
                                : commandLine.Output;
  std::vector<NamedFile> outputs{ { "--output", picture }, { "--html", commandLine.Html },
    { "--stats", commandLine.Stats }, { "--pixel-json", commandLine.PixelJson } };
  outputs.erase(
    std::remove_if(outputs.begin(), outputs.end(),
      [](const NamedFile& file) { return file.Path.empty() || file.Path == ToStandardOutput; }),
    outputs.end());
  return outputs;
}

void CheckFiles(const CommandLine& commandLine)
{
  std::vector<NamedFile> others = ListInputs(commandLine);
  for (const NamedFile& output : ListOutputs(commandLine))
  {
    for (const NamedFile& other : others)
    {
      if (AreSame(output.Path, other.Path))
      {
        throw UsageError(output.What + " '" + output.Path + "' would overwrite " + other.What +
                         ", which is the same file");
      }
    }
    others.push_back({ "what " + output.What + " writes", output.Path });
  }
  for (const NamedFile& output : ListOutputs(commandLine))
  {
    const std::string problem = FindOutputProblem(output.Path);
    if (!problem.empty())
    {
      throw Failure("cannot write '" + output.Path + "': " + problem);
    }
  }
}

void CheckStandardOutput(const CommandLine& commandLine)
{
  std::vector<std::string> users;
  const auto add = [&users](bool uses, const char* what)
  {
    if (uses)
    {
      users.emplace_back(what);
    }
  };
  const bool isPicture = commandLine.Output == ToStandardOutput;
  add(isPicture, "--output -");
  add(commandLine.Html == ToStandardOutput, "--html -");
  add(commandLine.Stats == ToStandardOutput, "--stats -");
  add(commandLine.PixelJson == ToStandardOutput, "--pixel-json -");
  add(commandLine.Pixel && commandLine.PixelJson != ToStandardOutput, "the text of --pixel");
  add(commandLine.Frames > 0 && commandLine.Stats.empty(), "the time of --frames");
  const bool hasName = isPicture || commandLine.Html == ToStandardOutput ||
                       commandLine.Stats == ToStandardOutput ||
                       commandLine.PixelJson == ToStandardOutput;
  if (hasName && users.size() > 1)
  {
    throw UsageError(
      users[0] + " and " + users[1] + " both go to standard output; name a file for one of them");
  }
  if (isPicture && (commandLine.Time || commandLine.Turntable > 0))
  {
    throw UsageError("--output - is for one picture, but --time and --turntable draw a series");
  }
  if (isPicture && isatty(STDOUT_FILENO))
  {
    throw UsageError("--output - writes a picture to standard output, which is a terminal here; "
                     "redirect it or name a file");
  }
}
} // namespace

namespace tetmarch
{

std::string ParseOutputName(const std::string& value)
{
  return value == "/dev/stdout" ? ToStandardOutput : value;
}

std::string ParsePictureName(const std::string& value)
{
  const std::string ending = GetEnding(value);
  if (!ending.empty() && ending != ".png")
  {
    throw UsageError("pictures are written as PNG alone; give a name that ends in .png");
  }
  return ParseOutputName(value);
}

std::string ParsePageName(const std::string& value)
{
  const std::string ending = GetEnding(value);
  if (!ending.empty() && ending != ".html" && ending != ".htm")
  {
    throw UsageError("pages are written as HTML alone; give a name that ends in .html");
  }
  return ParseOutputName(value);
}

void CheckOutputs(const CommandLine& commandLine)
{
  CheckStandardOutput(commandLine);
  CheckFiles(commandLine);
}

void WriteOutput(const std::string& name, std::string_view bytes)
{
  name == ToStandardOutput ? PrintText(bytes) : WriteFile(name, bytes);
}

} // namespace tetmarch
