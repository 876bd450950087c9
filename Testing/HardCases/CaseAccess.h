// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cases by name, for tests: an unknown name throws
 */
#ifndef tetmarch_testing_CaseAccess_h
#define tetmarch_testing_CaseAccess_h

#include "HardCase.h"

#include <stdexcept>
#include <string_view>

namespace tetmarch::testing
{
// What refers to the case refers to nothing of the name, as compilers would suspect of a reference.
inline const HardCase& caseOf(std::string_view name)
{
  const HardCase* hard = findHardCase(std::string(name));
  if (!hard)
  {
    throw std::invalid_argument("there is no hard case " + std::string(name));
  }
  return *hard;
}

inline Grid gridOf(std::string_view name) { return caseOf(name).Make(); }
} // namespace tetmarch::testing

#endif
