// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Choice.h"

#include "ColorMaps.h"
#include "DatasetReader.h"
#include "ErrorText.h"
#include "Failure.h"
#include "Messages.h"
#include "TransferFunctionPreset.h"

#include "vtkDataArray.h"

namespace tetmarch
{

namespace
{
void TakePreset(
  const VolumeData& data, const CommandLine& commandLine, vtkTetMarchFirstPicture* choice)
{
  const TransferFunctions preset = ReadPreset(commandLine.Preset, commandLine.Range);
  choice->GetColor()->DeepCopy(preset.Color);
  choice->GetOpacity()->DeepCopy(preset.Opacity);
  if (commandLine.UnitDistance)
  {
    return;
  }
  if (data.Structured) // what presets of images are made for
  {
    choice->SetUnitDistance(GetMeanSpacing(data));
  }
  else
  {
    choice->ChooseUnitDistance(preset.Opacity);
  }
}
} // namespace

VolumeData ReadInput(const CommandLine& commandLine, std::optional<int> timeStep)
{
  return ReadVolume(commandLine.Input, timeStep, commandLine.Raw,
    { commandLine.Array, commandLine.ArrayAssociation, !commandLine.Nearest.value_or(true) });
}

vtkSmartPointer<vtkTetMarchFirstPicture> ChooseArray(
  const VolumeData& data, const CommandLine& commandLine)
{
  auto choice = vtkSmartPointer<vtkTetMarchFirstPicture>::New();
  const ErrorText error(choice);
  choice->SetInputData(data.Input);
  choice->SetArrayName(commandLine.Array);
  choice->SetArrayAssociation(commandLine.ArrayAssociation);
  if (commandLine.Component)
  {
    choice->SetComponent(*commandLine.Component);
  }
  if (commandLine.Range)
  {
    choice->SetRange(commandLine.Range->data());
  }
  if (commandLine.Given.count("--opacity-law"))
  {
    choice->SetOpacityLaw(commandLine.Settings->GetOpacityLaw());
  }
  if (!choice->ChooseArray())
  {
    throw Failure(error.Get());
  }
  return choice;
}

vtkSmartPointer<vtkTetMarchFirstPicture> MakeChoice(
  const VolumeData& data, const CommandLine& commandLine)
{
  auto choice = ChooseArray(data, commandLine);
  const ErrorText error(choice);
  if (!commandLine.Preset.empty())
  {
    TakePreset(data, commandLine, choice);
  }
  else if (!choice->ChooseTransferFunctions())
  {
    throw Failure(error.Get());
  }
  if (!commandLine.Colors.empty())
  {
    const auto range = GetColorRange(choice, commandLine);
    ApplyColorMap(commandLine.Colors, range[0], range[1], choice->GetColor());
  }
  if (commandLine.UnitDistance)
  {
    choice->SetUnitDistance(*commandLine.UnitDistance);
  }
  return choice;
}

std::string GetTitle(vtkTetMarchFirstPicture* choice)
{
  vtkDataArray* array = choice->GetChosenArray();
  const int component = choice->GetChosenComponent();
  const std::string part = array->GetNumberOfComponents() == 1 ? ""
                           : component < 0                     ? " (magnitude)"
                                           : " (component " + std::to_string(component) + ")";
  return array->GetName() + part;
}

std::array<double, 2> GetColorRange(vtkTetMarchFirstPicture* choice, const CommandLine& commandLine)
{
  std::array<double, 2> range;
  if (commandLine.Preset.empty())
  {
    choice->GetChosenRange(range.data());
  }
  else
  {
    choice->GetColor()->GetRange(range.data());
  }
  return range;
}

void TellChoice(vtkTetMarchFirstPicture* choice, const CommandLine& commandLine)
{
  if (commandLine.Array.empty())
  {
    PrintNote("drawing " + choice->Describe() + " (--list shows all arrays)");
  }
}

} // namespace tetmarch
