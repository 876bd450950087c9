// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What tetmarch-render says of arguments that it refuses
 */
#ifndef tetmarch_testing_CommandLineErrors_h
#define tetmarch_testing_CommandLineErrors_h

#include "CommandLine.h"
#include "Failure.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

using tetmarch::CommandLine;
using tetmarch::ParseCommandLine;

/// The message, or "accepted".
inline std::string GetError(const std::vector<std::string>& arguments)
{
  try
  {
    ParseCommandLine(arguments);
  }
  catch (const tetmarch::UsageError& error)
  {
    return error.what();
  }
  return "accepted";
}

inline void ExpectBadValue(
  const std::string& option, const std::string& value, const std::string& reason)
{
  EXPECT_EQ(
    GetError({ "a.vtu", option, value }), "bad value '" + value + "' of " + option + ": " + reason);
}

#endif
