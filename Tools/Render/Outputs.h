// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The files that the command line asks for.
 */
#ifndef tetmarch_Outputs_h
#define tetmarch_Outputs_h

#include "CommandLine.h"

#include <string>
#include <string_view>

namespace tetmarch
{

/// The name of standard output: "-", also for "/dev/stdout".
std::string ParseOutputName(const std::string& value);

/// The same of a picture. Throws UsageError if the ending is that of another format than PNG.
std::string ParsePictureName(const std::string& value);

/// The same of a page. Throws UsageError if the ending is that of another format than HTML.
std::string ParsePageName(const std::string& value);

/// Looks at the files of the command line before any of them is read. Throws UsageError if an
/// output would overwrite an input or another output, or several go to standard output, and Failure
/// if a file can't be written.
void CheckOutputs(const CommandLine& commandLine);

/// To a file that stays as it was if this fails, or to standard output. Throws Failure.
void WriteOutput(const std::string& name, std::string_view bytes);

} // namespace tetmarch

#endif
