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

namespace tetmarch::testing
{
inline const HardCase& caseOf(const std::string& name)
{
  const HardCase* hard = findHardCase(name);
  if (!hard)
  {
    throw std::invalid_argument("there is no hard case " + name);
  }
  return *hard;
}

inline Grid gridOf(const std::string& name) { return caseOf(name).Make(); }
} // namespace tetmarch::testing

#endif
