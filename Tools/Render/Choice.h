// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What is drawn, and how: as the command line says, the rest as vtkTetMarchFirstPicture chooses.
 */
#ifndef tetmarch_Choice_h
#define tetmarch_Choice_h

#include "CommandLine.h"
#include "VolumeData.h"

#include "vtkSmartPointer.h"
#include "vtkTetMarchFirstPicture.h"

#include <array>
#include <optional>

namespace tetmarch
{

/// A time step of the input; none: the last. Of blocks those with the array that is asked for.
/// Throws Failure that says what is wrong with the file.
VolumeData ReadInput(const CommandLine& commandLine, std::optional<int> timeStep);

/// The array alone. Throws Failure if there is no such array.
vtkSmartPointer<vtkTetMarchFirstPicture> ChooseArray(
  const VolumeData& data, const CommandLine& commandLine);

/// The array and its transfer functions. Throws Failure, also if a preset can't be read.
vtkSmartPointer<vtkTetMarchFirstPicture> MakeChoice(
  const VolumeData& data, const CommandLine& commandLine);

/// "velocity (magnitude)".
std::string GetTitle(vtkTetMarchFirstPicture* choice);

/// The range of scalars over which colours run.
std::array<double, 2> GetColorRange(
  vtkTetMarchFirstPicture* choice, const CommandLine& commandLine);

/// Tells on stderr what was chosen, if the command line left it open.
void TellChoice(vtkTetMarchFirstPicture* choice, const CommandLine& commandLine);

} // namespace tetmarch

#endif
