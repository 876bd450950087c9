// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The command line of tetmarch-view.
 */
#ifndef tetmarch_Arguments_h
#define tetmarch_Arguments_h

#include <string>
#include <vector>

namespace tetmarch
{

struct Arguments
{
  bool Help = false;
  bool Version = false;
  std::string File; // empty: none
};

/// Those after the program's name. Throws UsageError.
Arguments ParseArguments(const std::vector<std::string>& arguments);

std::string GetViewHelp();

/// What is wrong and what to do instead, if there is no display for a window; else empty.
std::string FindDisplayProblem();

} // namespace tetmarch

#endif
