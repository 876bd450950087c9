// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Series.h"

#include "Choice.h"
#include "Failure.h"
#include "Page.h"
#include "Picture.h"
#include "ProgressBar.h"
#include "TimeSteps.h"
#include "TimeSurvey.h"

#include "FirstPicture/RangeText.h"

#include "vtkCommand.h"
#include "vtkObject.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

namespace tetmarch
{

namespace
{

/// One bar over all of a series.
class SeriesProgress
{
public:
  SeriesProgress(const std::string& stage, int count)
    : Count(count)
    , Bar(stage, this->Source)
  {
  }

  void AddOne()
  {
    double fraction = static_cast<double>(++this->Done) / this->Count;
    this->Source->InvokeEvent(vtkCommand::ProgressEvent, &fraction);
  }

private:
  vtkNew<vtkObject> Source;
  int Count;
  int Done = 0;
  ProgressBar Bar;
};

std::vector<int> ListTimeSteps(const CommandLine& commandLine)
{
  const int count = static_cast<int>(GetTimeSteps(commandLine.Input, commandLine.Raw).size());
  if (count == 0)
  {
    throw Failure("'" + commandLine.Input + "' has no time steps for --time to draw");
  }
  const int last = commandLine.Time->Last.value_or(count - 1);
  if (last >= count)
  {
    throw Failure("time step " + std::to_string(last) + " does not exist: the file has " +
                  std::to_string(count) + ", counted from 0 to " + std::to_string(count - 1));
  }
  std::vector<int> steps;
  for (int step = commandLine.Time->First; step <= last; ++step)
  {
    steps.push_back(step);
  }
  return steps;
}

/// One picture of a time step.
struct TimeFrame
{
  int Step;
  int Number; // of its file
};

/// On a turntable the steps go by evenly during one turn; else each is drawn once, by its number.
std::vector<TimeFrame> ListFrames(const std::vector<int>& steps, int turntable)
{
  std::vector<TimeFrame> frames;
  if (turntable == 0)
  {
    for (const int step : steps)
    {
      frames.push_back({ step, step });
    }
  }
  for (int frame = 0; frame < turntable; ++frame)
  {
    frames.push_back({ steps[steps.size() * static_cast<std::size_t>(frame) / turntable], frame });
  }
  return frames;
}

/// Of a time step in a page, with enough digits to tell it from others.
std::string GetLabel(const std::vector<double>& times, int step)
{
  const double time = times.at(static_cast<std::size_t>(step));
  const double between = (times.back() - times.front()) / static_cast<double>(times.size());
  return "time " + numberText(time, digitsWithin(time, between / 100.0));
}

} // namespace

std::string GetFrameName(const std::string& path, int frame, int count)
{
  const std::size_t digits = std::max<std::size_t>(4, std::to_string(count - 1).size());
  const std::string number = std::to_string(frame);
  const std::filesystem::path whole(path);
  const std::string name = whole.stem().string() + "_" +
                           std::string(digits - std::min(digits, number.size()), '0') + number +
                           whole.extension().string();
  return (whole.parent_path() / name).string();
}

void DrawTurntable(const CommandLine& commandLine)
{
  const VolumeData data = ReadInput(commandLine, commandLine.TimeStep);
  const auto choice = MakeChoice(data, commandLine);
  TellChoice(choice, commandLine);
  Picture picture(data, GetBounds(data).data(), choice, commandLine);
  const int count = commandLine.Turntable;
  SeriesProgress progress("rendering", count);
  for (int frame = 0; frame < count; ++frame)
  {
    picture.Render();
    picture.Write(GetFrameName(commandLine.Output, frame, count));
    picture.Turn(360.0 / count);
    progress.AddOne();
  }
}

void DrawTimeSteps(const CommandLine& commandLine)
{
  const std::vector<int> steps = ListTimeSteps(commandLine);
  const TimeSurvey survey = SurveyTimeSteps(commandLine, steps);
  TellChoice(survey.Choice, commandLine);
  const std::vector<TimeFrame> frames = ListFrames(steps, commandLine.Turntable);
  std::unique_ptr<Picture> picture;
  Page page(commandLine, GetTitle(survey.Choice));
  std::optional<int> read;
  std::string label;
  SeriesProgress progress("rendering", static_cast<int>(frames.size()));
  for (const TimeFrame& frame : frames)
  {
    if (read != frame.Step)
    {
      const VolumeData data = ReadInput(commandLine, frame.Step);
      if (!picture)
      {
        picture = std::make_unique<Picture>(data, survey.Bounds.data(), survey.Choice, commandLine);
      }
      picture->SetData(data);
      read = frame.Step;
      label = GetLabel(data.Times, frame.Step);
    }
    picture->Render();
    if (!commandLine.Output.empty())
    {
      picture->Write(GetFrameName(commandLine.Output, frame.Number, frames.back().Number + 1));
    }
    page.Add(*picture, label);
    if (commandLine.Turntable > 0)
    {
      picture->Turn(360.0 / commandLine.Turntable);
    }
    progress.AddOne();
  }
  page.Write();
}

} // namespace tetmarch
