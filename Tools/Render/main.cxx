// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayList.h"
#include "Choice.h"
#include "ColorMaps.h"
#include "CommandLine.h"
#include "DatasetReader.h"
#include "Failure.h"
#include "Messages.h"
#include "Outputs.h"
#include "Page.h"
#include "Picture.h"
#include "PixelTrace.h"
#include "ReaderCrash.h"
#include "Series.h"
#include "StandardOutput.h"
#include "Statistics.h"
#include "TextTable.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"
#include "vtkTetMarchFrameStatistics.h"
#include "vtkTimerLog.h"
#include "vtkVersion.h"

#include <cstdlib>

namespace
{
using namespace tetmarch;

/// Before a GL is made: Mesa's llvmpipe reads the variable then.
void LimitThreads(int count)
{
  setenv("LP_NUM_THREADS", std::to_string(count).c_str(), 1);
  vtkSMPTools::Initialize(count);
}

void ShowPixel(Picture& picture, const VolumeData& data, const std::string& arrayName,
  const CommandLine& commandLine)
{
  PixelTrace trace;
  picture.Trace(*commandLine.Pixel, trace);
  vtkTetMarchFrameStatistics* statistics = picture.GetMapper().GetStatistics();
  trace.Structured = data.Structured || statistics->GetNumberOfLatticeCells() > 0;
  const std::string text = FormatPixelText(commandLine, arrayName, statistics, trace);
  const std::string json = FormatPixelJson(commandLine, arrayName, statistics, trace);
  WriteOutput("-", commandLine.PixelJson == "-" ? json : text);
  if (!commandLine.PixelJson.empty() && commandLine.PixelJson != "-")
  {
    WriteOutput(commandLine.PixelJson, json);
  }
}

void ListColors()
{
  std::string names;
  for (const std::string& name : GetColorMapNames())
  {
    names += name + "\n";
  }
  PrintText(names);
}

void ListArrays(const CommandLine& commandLine)
{
  const VolumeData data = ReadInput(commandLine, commandLine.TimeStep);
  PrintText(FormatArrayList(ChooseArray(data, commandLine), data.Times));
}

void CheckFile(const CommandLine& commandLine)
{
  const std::vector<std::string> faults =
    ListFaults(commandLine.Input, commandLine.TimeStep, commandLine.Raw);
  for (const std::string& fault : faults)
  {
    std::printf("%s\n", fault.c_str());
  }
  if (!faults.empty())
  {
    throw Failure("'" + commandLine.Input + "' has " + std::to_string(faults.size()) +
                  (faults.size() == 1 ? " fault" : " faults"));
  }
  std::printf("no fault\n");
}

void DrawOne(const CommandLine& commandLine)
{
  Timing timing;
  const double begin = vtkTimerLog::GetUniversalTime();
  const VolumeData data = ReadInput(commandLine, commandLine.TimeStep);
  timing.Read = vtkTimerLog::GetUniversalTime() - begin;

  const auto choice = MakeChoice(data, commandLine);
  TellChoice(choice, commandLine);
  Picture picture(data, GetBounds(data).data(), choice, commandLine);
  timing.FirstFrame = picture.Render();
  if (commandLine.Settings->GetFrameTimeBudget() > 0.0)
  {
    picture.Settle();
  }
  if (!commandLine.Output.empty())
  {
    picture.Write(commandLine.Output);
  }
  Page page(commandLine, GetTitle(choice));
  page.Add(picture);
  page.Write();

  for (int i = 0; i < commandLine.Frames; ++i)
  {
    timing.Frames.push_back(picture.Render());
  }
  if (!commandLine.Stats.empty())
  {
    if (commandLine.Compare)
    {
      picture.Compare();
    }
    WriteOutput(
      commandLine.Stats, FormatStatistics(commandLine, data, choice,
                           picture.GetMapper().GetStatistics(), picture.GetWindow(), timing));
  }
  else if (commandLine.Frames > 0)
  {
    PrintText(FormatFixed(GetMedian(timing.Frames), 6) + " s a frame (median of " +
              std::to_string(commandLine.Frames) + ")\n");
  }
  if (commandLine.Pixel)
  {
    ShowPixel(picture, data, choice->GetChosenArray()->GetName(), commandLine);
  }
}

void Draw(const CommandLine& commandLine)
{
  if (commandLine.Time)
  {
    DrawTimeSteps(commandLine);
  }
  else if (commandLine.Turntable > 0)
  {
    DrawTurntable(commandLine);
  }
  else
  {
    DrawOne(commandLine);
  }
}

void Run(const CommandLine& commandLine)
{
  if (commandLine.Quiet)
  {
    BeQuiet();
  }
  if (commandLine.Threads > 0)
  {
    LimitThreads(commandLine.Threads);
  }
  if (commandLine.ListColors)
  {
    ListColors();
  }
  else if (commandLine.Check)
  {
    CheckFile(commandLine);
  }
  else if (commandLine.List)
  {
    ListArrays(commandLine);
  }
  else
  {
    CheckOutputs(commandLine);
    Draw(commandLine);
  }
}
} // namespace

int main(int argc, char* argv[])
{
  Messages::Install();
  TellCrashesOfReaders();
  try
  {
    const CommandLine commandLine = ParseCommandLine({ argv + 1, argv + argc });
    if (commandLine.Help)
    {
      PrintText(GetHelp());
    }
    else if (commandLine.Version)
    {
      PrintText(std::string("tetmarch-render ") + TETMARCH_VERSION + " (VTK " +
                vtkVersion::GetVTKVersion() + ")\n");
    }
    else
    {
      Run(commandLine);
    }
    return 0;
  }
  catch (const UsageError& error)
  {
    PrintMessage("error", std::string(error.what()) + " (--help shows the options)");
    return 2;
  }
  catch (const std::exception& error)
  {
    PrintMessage("error", error.what());
    return 1;
  }
}
