// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The time steps of a file.
 */
#ifndef tetmarch_TimeSteps_h
#define tetmarch_TimeSteps_h

#include "RawImage.h"

#include <string>
#include <vector>

class vtkAlgorithm;

namespace tetmarch
{

/// The times of a reader's file; none if the file tells of no time. Reads no values.
std::vector<double> GetTimeSteps(vtkAlgorithm* reader);

/// The same of a path. Throws Failure if it can't be read.
std::vector<double> GetTimeSteps(const std::string& path, const RawOptions& rawOptions = {});

} // namespace tetmarch

#endif
