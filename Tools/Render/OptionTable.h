// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The options that have a value, and what each sets.
 */
#ifndef tetmarch_OptionTable_h
#define tetmarch_OptionTable_h

#include "CommandLine.h"

#include <string>

namespace tetmarch
{

/// Of a name with its dashes.
bool IsOptionWithValue(const std::string& name);

/// Throws UsageError, which names the option and says what was expected.
void SetOption(CommandLine& commandLine, const std::string& name, const std::string& value);

/// Whoever asks for something of light wants it to shine.
LightOptions& LightOf(CommandLine& commandLine);

} // namespace tetmarch

#endif
