// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Options that don't go together, or not with the data.
 */
#ifndef tetmarch_OptionChecks_h
#define tetmarch_OptionChecks_h

#include "CommandLine.h"
#include "VolumeData.h"

namespace tetmarch
{

/// Whether the colours of a view are those of a measure: the error bound, cells or lookups.
bool ShowsMeasure(int viewMode);

/// Throws UsageError.
void CheckOptions(const CommandLine& commandLine);

/// Throws Failure if what is asked for isn't to be had of such data.
void CheckOptionsOfData(const CommandLine& commandLine, const VolumeData& data);

} // namespace tetmarch

#endif
