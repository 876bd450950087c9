// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Lets operator new fail
 *
 * An executable that uses it gets another operator new for the whole process, which does what the
 * standard one does unless told otherwise here.
 */
#ifndef tetmarch_testing_ScarceMemory_h
#define tetmarch_testing_ScarceMemory_h

#include <cstddef>

namespace tetmarch::testing
{
/// As long as it lives, allocations of at least so many bytes throw std::bad_alloc: all of them,
/// or one, after so many that succeed. One at a time.
class ScarceMemory
{
public:
  explicit ScarceMemory(std::size_t bytes);
  ScarceMemory(std::size_t bytes, int successes);
  /// The same of those alone that are called from the library that has the address: of what it
  /// calls in turn, other libraries and the GL, none fails.
  ScarceMemory(std::size_t bytes, int successes, const void* library);
  ~ScarceMemory();
  ScarceMemory(const ScarceMemory&) = delete;
  ScarceMemory& operator=(const ScarceMemory&) = delete;

  /// Allocations that failed so far.
  static int failures();
  /// Allocations that could have failed so far, of a ScarceMemory with a number of successes.
  static int tries();
};
} // namespace tetmarch::testing

#endif
