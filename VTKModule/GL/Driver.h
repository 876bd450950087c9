// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Features and needs of the driver of the current context.
#ifndef TetMarchGLDriver_h
#define TetMarchGLDriver_h

#include <string>

namespace tetmarch
{

bool hasExtension(const char* name);
/** Whether the context is of this version of OpenGL, or a later one. */
bool hasVersion(int major, int minor);

/** Shader defines that depend on the driver and not on the scene: see Shaders/passes/helper.glsl,
 * Shaders/structured/lattice_buffers.glsl and Shaders/language.glsl.
 * Keep them as long as the context lives: each query goes through all of Mesa's extensions. */
std::string driverDefines();

} // namespace tetmarch

#endif
