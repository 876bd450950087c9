// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * All that a file holds of one time step.
 */
#ifndef tetmarch_FileContents_h
#define tetmarch_FileContents_h

#include "ProgressBar.h"
#include "RawImage.h"

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

namespace tetmarch
{

struct FileContents
{
  vtkSmartPointer<vtkDataObject> Data;
  std::vector<double> Times; // of all time steps; empty if the file has none
  /// Of a parallel file, which repeat the points between them and their neighbours' cells.
  bool OfPieces = false;
};

/// By default of the last time step. Throws Failure that says what is wrong with the file, and
/// Cancelled if the report asks to stop.
FileContents ReadFile(const std::string& path, std::optional<int> timeStep,
  const RawOptions& rawOptions, const ProgressReport& report);

} // namespace tetmarch

#endif
