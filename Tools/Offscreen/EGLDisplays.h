// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The EGL displays of a machine that need no display server, best first.
 */
#ifndef tetmarch_EGLDisplays_h
#define tetmarch_EGLDisplays_h

#include "EGLLibrary.h"

#include <functional>
#include <memory>

namespace tetmarch
{

/// An initialized display; terminated with its last user.
struct EGLDisplayHolder
{
  explicit EGLDisplayHolder(EGLDisplay display)
    : Display(display)
  {
  }
  EGLDisplayHolder(const EGLDisplayHolder&) = delete;
  EGLDisplayHolder& operator=(const EGLDisplayHolder&) = delete;
  ~EGLDisplayHolder();

  const EGLDisplay Display;
};

/**
 * Offer displays to use() until it returns true: the one in use already; the device that
 * VTK_DEFAULT_EGL_DEVICE_INDEX names, and no other, if it is set; else GPU devices, software
 * devices, Mesa's surfaceless platform, the default display.
 */
void ForEachEGLDisplay(const std::function<bool(std::shared_ptr<EGLDisplayHolder>)>& use);

} // namespace tetmarch

#endif
