// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include "Failure.h"
#include "OptionTable.h"

#include <filesystem>

namespace
{
using namespace tetmarch;

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
} // namespace

namespace tetmarch
{

CommandLine ParseCommandLine(const std::vector<std::string>& arguments)
{
  CommandLine commandLine;
  std::vector<std::string> inputs;
  bool framesGiven = false;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& argument = arguments[i];
    if (argument.size() < 2 || argument[0] != '-')
    {
      inputs.push_back(argument);
      continue;
    }
    if (argument == "--")
    {
      inputs.insert(inputs.end(), arguments.begin() + i + 1, arguments.end());
      break;
    }
    if (argument == "--help" || argument == "-h")
    {
      commandLine.Help = true;
      return commandLine;
    }
    if (argument == "--version")
    {
      commandLine.Version = true;
      return commandLine;
    }
    if (argument == "--compare")
    {
      commandLine.Compare = true;
      continue;
    }
    if (argument == "--jitter")
    {
      commandLine.Jitter = true;
      continue;
    }
    if (argument == "--shade")
    {
      commandLine.Light.Shade = true;
      continue;
    }
    if (argument == "--big-endian")
    {
      commandLine.Raw.BigEndian = true;
      continue;
    }
    if (argument == "--opaque-shadows")
    {
      LightOf(commandLine).OpaqueShadows = true;
      continue;
    }
    const auto equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    if (!IsOptionWithValue(name))
    {
      throw UsageError("unknown option '" + name + "'");
    }
    framesGiven = framesGiven || name == "--frames";
    if (equals != std::string::npos)
    {
      SetOption(commandLine, name, argument.substr(equals + 1));
    }
    else if (i + 1 == arguments.size() || arguments[i + 1].compare(0, 2, "--") == 0)
    {
      throw UsageError("option " + name + " needs a value");
    }
    else
    {
      SetOption(commandLine, name, arguments[++i]);
    }
  }
  if (commandLine.Compare && commandLine.Stats.empty())
  {
    throw UsageError("--compare adds to the figures of --stats, which is missing");
  }
  CheckPixel(commandLine);
  if (inputs.size() != 1 || inputs[0].empty())
  {
    throw UsageError(inputs.size() > 1
                       ? "more than one input: '" + inputs[0] + "' and '" + inputs[1] + "'"
                       : "no input file is given");
  }
  commandLine.Input = inputs[0];
  commandLine.Raw = CompleteRawOptions(commandLine.Raw, commandLine.Input);
  if (commandLine.Output.empty() && !commandLine.Pixel)
  {
    commandLine.Output = std::filesystem::path(commandLine.Input).stem().string() + ".png";
  }
  if (!framesGiven && !commandLine.Stats.empty())
  {
    commandLine.Frames = 5;
  }
  return commandLine;
}

} // namespace tetmarch
