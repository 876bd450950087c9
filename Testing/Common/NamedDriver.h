// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The driver of Mesa that GALLIUM_DRIVER names; include it where TetMarchOffscreen is linked
 */
#ifndef tetmarch_testing_NamedDriver_h
#define tetmarch_testing_NamedDriver_h

#include "OffscreenWindow.h"

#include <cstdlib>
#include <string>

namespace tetmarch::testing
{
/// Such as softpipe; empty: none is named, and any is meant.
inline std::string namedDriver()
{
  const char* name = std::getenv("GALLIUM_DRIVER");
  return name ? name : "";
}

/// Empty if the named driver serves the GL of offscreen windows; else what does instead.
inline std::string whatServesInstead()
{
  std::string error;
  const auto window = MakeOffscreenWindow(8, 8, &error);
  const std::string found = window ? GetGLInformation(window).Renderer : error;
  return found.find(namedDriver()) == 0
           ? ""
           : "GALLIUM_DRIVER is '" + namedDriver() + "', but there is: " + found;
}
} // namespace tetmarch::testing

#endif
