// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A look at all time steps before the first is drawn, so that one choice is right for all of them.
 */
#ifndef tetmarch_TimeSurvey_h
#define tetmarch_TimeSurvey_h

#include "CommandLine.h"

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkTetMarchFirstPicture;

namespace tetmarch
{

struct TimeSurvey
{
  /// The array that the last step would have. Its range holds what each step would have chosen,
  /// unless the command line says which. The step with the widest range of its own has chosen the
  /// rest.
  vtkSmartPointer<vtkTetMarchFirstPicture> Choice;
  /// Of the data of all steps.
  std::array<double, 6> Bounds;
};

/// Reads one step after the other. Throws Failure.
TimeSurvey SurveyTimeSteps(const CommandLine& commandLine, const std::vector<int>& steps);

} // namespace tetmarch

#endif
