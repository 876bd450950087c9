// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Features and needs of the driver of the current context.
#ifndef TetMarchGLDriver_h
#define TetMarchGLDriver_h

#include <cstddef>
#include <string>

namespace tetmarch
{

bool hasExtension(const char* name);
/** Whether the context is of this version of OpenGL, or a later one. */
bool hasVersion(int major, int minor);

/** How many texels of any format a texture buffer of the current context holds:
 * GL_MAX_TEXTURE_BUFFER_SIZE, or less where the driver is known to read fewer. */
std::size_t mostTexels();

/** Whether a pixel can write an element of its own to an array of its shader, as the search for
 * entries does. Mesa's softpipe writes to where the first of four pixels points (Mesa 22.3), and so
 * never comes to an end of that search. */
bool writesArrays();

/** How many textures a fragment or a compute shader may read. */
int textureUnits(bool ofCompute);

/** What the current context lacks that every picture needs; empty if it lacks nothing. */
std::string describeMissing();

/** Shader defines that depend on the driver and not on the scene: see Shaders/passes/helper.glsl,
 * Shaders/structured/lattice_buffers.glsl and Shaders/language.glsl.
 * Keep them as long as the context lives: each query goes through all of Mesa's extensions. */
std::string driverDefines();

} // namespace tetmarch

#endif
