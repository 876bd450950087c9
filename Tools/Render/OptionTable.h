// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * All options but --help and --version, and what each sets.
 */
#ifndef tetmarch_OptionTable_h
#define tetmarch_OptionTable_h

#include "CommandLine.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace tetmarch
{

struct Option
{
  enum Values
  {
    NONE,
    FILE_NAME,
    OTHER
  };

  Values Value = OTHER;
  std::vector<std::string> Words; // values that are known beforehand
  std::function<void(CommandLine&, const std::string& value)> Set;
};

/// By names with their dashes.
const std::map<std::string, Option>& GetOptions();

/// Throws UsageError, which names the option and says what was expected.
void SetOption(CommandLine& commandLine, const std::string& name, const std::string& value);

} // namespace tetmarch

#endif
