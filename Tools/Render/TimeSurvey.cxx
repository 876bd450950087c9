// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TimeSurvey.h"

#include "Choice.h"
#include "Failure.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"

#include <algorithm>

namespace tetmarch
{

namespace
{

/// The same command line, which says by name what was chosen.
CommandLine NameArray(const CommandLine& commandLine, vtkTetMarchFirstPicture* choice)
{
  CommandLine named = commandLine;
  named.Array = choice->GetChosenArray()->GetName();
  named.ArrayAssociation = choice->GetChosenAssociation();
  named.Component = choice->GetChosenComponent();
  return named;
}

/// What ChooseArray() or MakeChoice() chooses. A failure names the step.
template <typename Chooser>
auto ChooseOfStep(Chooser choose, const VolumeData& data, const CommandLine& commandLine, int step)
{
  try
  {
    return choose(data, commandLine);
  }
  catch (const Failure& failure)
  {
    throw Failure(
      "time step " + std::to_string(step) + " of '" + commandLine.Input + "': " + failure.what());
  }
}

/// One mapper draws all steps.
void CheckKind(const VolumeData& data, int step, const VolumeData& last, const std::string& input)
{
  if (data.Structured != last.Structured)
  {
    throw Failure("time step " + std::to_string(step) + " of '" + input + "' has " +
                  (data.Structured ? "images or rectilinear grids" : "an unstructured grid") +
                  ", but the last step has not; --time draws steps of one kind");
  }
}

/// That of the colours; of values that are all equal no more than these.
std::array<double, 2> GetRangeOfStep(const VolumeData& data, const CommandLine& named, int step)
{
  const auto choice = ChooseOfStep(MakeChoice, data, named, step);
  std::array<double, 2> values;
  choice->GetDataRange(values.data());
  if (values[0] > values[1])
  {
    return { { VTK_DOUBLE_MAX, VTK_DOUBLE_MIN } };
  }
  return values[0] < values[1] ? GetColorRange(choice, named) : values;
}

} // namespace

TimeSurvey SurveyTimeSteps(const CommandLine& commandLine, const std::vector<int>& steps)
{
  const VolumeData last = ReadInput(commandLine, steps.back());
  CommandLine named =
    NameArray(commandLine, ChooseOfStep(ChooseArray, last, commandLine, steps.back()));
  vtkBoundingBox box;
  std::array<double, 2> all = { { VTK_DOUBLE_MAX, VTK_DOUBLE_MIN } };
  double widest = -1.0;
  VolumeData chooser = last;
  for (const int step : steps)
  {
    const VolumeData data = step == steps.back() ? last : ReadInput(named, step);
    CheckKind(data, step, last, commandLine.Input);
    box.AddBounds(GetBounds(data).data());
    const auto range = GetRangeOfStep(data, named, step);
    all = { { std::min(all[0], range[0]), std::max(all[1], range[1]) } };
    if (range[1] - range[0] > widest)
    {
      widest = range[1] - range[0];
      chooser = data;
    }
  }
  if (commandLine.Preset.empty() && all[0] < all[1])
  {
    named.Range = all;
  }
  TimeSurvey survey;
  survey.Choice = MakeChoice(chooser, named);
  box.GetBounds(survey.Bounds.data());
  return survey;
}

} // namespace tetmarch
