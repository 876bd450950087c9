// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Pictures in numbered files: from all sides, of time steps, or both.
 */
#ifndef tetmarch_Series_h
#define tetmarch_Series_h

#include "CommandLine.h"

#include <string>

namespace tetmarch
{

/// "a/b.png" becomes "a/b_0007.png", with as many digits as `count` frames need, 4 at least.
std::string GetFrameName(const std::string& path, int frame, int count);

/// Both throw Failure.
void DrawTurntable(const CommandLine& commandLine);
/// From all sides if there is a turntable, too.
void DrawTimeSteps(const CommandLine& commandLine);

} // namespace tetmarch

#endif
