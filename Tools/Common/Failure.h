// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The ways in which work ends early; programs turn them into a message and an exit status.
 */
#ifndef tetmarch_Failure_h
#define tetmarch_Failure_h

#include <stdexcept>
#include <string>

namespace tetmarch
{

/// The command line can't be understood: exit status 2.
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Something went wrong while doing what was asked: exit status 1.
struct Failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

[[noreturn]] inline void RefuseFile(const std::string& path, const std::string& reason)
{
  throw Failure("cannot read '" + path + "': " + reason);
}

/// Whoever asked for the work wants it no more.
struct Cancelled : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

} // namespace tetmarch

#endif
