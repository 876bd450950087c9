// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include "Failure.h"
#include "OptionChecks.h"
#include "OptionTable.h"

#include "vtkVolumeMapper.h"

#include <filesystem>

namespace
{
using namespace tetmarch;

struct Words
{
  CommandLine Result;
  std::vector<std::string> Inputs;
};

/// Sets the option at a place; returns the place of its last word.
std::size_t TakeOption(const std::vector<std::string>& arguments, std::size_t i, Words& words)
{
  const std::string& argument = arguments[i];
  const auto equals = argument.find('=');
  const std::string name = argument.substr(0, equals);
  const auto option = GetOptions().find(name);
  if (option == GetOptions().end())
  {
    throw UsageError("unknown option '" + name + "'");
  }
  words.Result.Given.insert(name);
  const bool hasValue = option->second.Value != Option::NONE;
  if (!hasValue && equals != std::string::npos)
  {
    throw UsageError("option " + name + " has no value");
  }
  if (!hasValue || equals != std::string::npos)
  {
    SetOption(words.Result, name, hasValue ? argument.substr(equals + 1) : "");
    return i;
  }
  if (i + 1 == arguments.size() || arguments[i + 1].compare(0, 2, "--") == 0)
  {
    throw UsageError("option " + name + " needs a value");
  }
  SetOption(words.Result, name, arguments[i + 1]);
  return i + 1;
}

/// What some options imply, if the option that says it is missing.
void Imply(CommandLine& commandLine)
{
  if (commandLine.SampleDistance && !commandLine.Given.count("--accuracy"))
  {
    commandLine.Settings->SetAccuracyLevelToSampled();
  }
  if (!commandLine.IsoValues.empty() && !commandLine.Given.count("--blend"))
  {
    commandLine.BlendMode = vtkVolumeMapper::ISOSURFACE_BLEND;
  }
  if (!commandLine.Stats.empty() && !commandLine.Given.count("--frames"))
  {
    commandLine.Frames = 5;
  }
}

void Complete(Words& words)
{
  CommandLine& commandLine = words.Result;
  const std::vector<std::string>& inputs = words.Inputs;
  if (inputs.size() != 1 || inputs[0].empty())
  {
    throw UsageError(inputs.size() > 1
                       ? "more than one input: '" + inputs[0] + "' and '" + inputs[1] + "'"
                       : "no input file is given");
  }
  commandLine.Input = inputs[0];
  commandLine.Raw = CompleteRawOptions(commandLine.Raw, commandLine.Input);
  if (commandLine.Output.empty() && commandLine.Html.empty() && !commandLine.Pixel)
  {
    commandLine.Output = std::filesystem::path(commandLine.Input).stem().string() + ".png";
  }
}
} // namespace

namespace tetmarch
{

CommandLine ParseCommandLine(const std::vector<std::string>& arguments)
{
  Words words;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& argument = arguments[i];
    if (argument.size() < 2 || argument[0] != '-')
    {
      words.Inputs.push_back(argument);
    }
    else if (argument == "--")
    {
      words.Inputs.insert(words.Inputs.end(), arguments.begin() + i + 1, arguments.end());
      break;
    }
    else if (argument == "--help" || argument == "-h")
    {
      words.Result.Help = true;
      return words.Result;
    }
    else if (argument == "--version")
    {
      words.Result.Version = true;
      return words.Result;
    }
    else
    {
      i = TakeOption(arguments, i, words);
    }
  }
  if (words.Result.ListColors)
  {
    return words.Result;
  }
  Imply(words.Result);
  CheckOptions(words.Result);
  Complete(words);
  return words.Result;
}

} // namespace tetmarch
