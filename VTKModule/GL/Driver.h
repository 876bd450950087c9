// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the driver of the current context has, and what it needs.
#ifndef TetMarchGLDriver_h
#define TetMarchGLDriver_h

#include <string>

namespace tetmarch
{

bool hasExtension(const char* name);

/**
 * Defines of the shaders that come from the driver instead of the scene: see
 * Shaders/passes/helper.glsl. Keep them as long as the context lives: each question goes through
 * all of Mesa's extensions.
 */
std::string driverDefines();

} // namespace tetmarch

#endif
