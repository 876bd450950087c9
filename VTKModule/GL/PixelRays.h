// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Binds what Shaders/passes/pixel_ray.glsl reads.
#ifndef TetMarchGLPixelRays_h
#define TetMarchGLPixelRays_h

#include "GL/MarchPass.h"

class vtkShaderProgram;

namespace tetmarch
{

/** The rays of a target's pixels: camera, entries and depths of the inputs, as far as their key
 * needs them. */
void bindPixelRays(vtkShaderProgram* program, const MarchInputs& inputs, const Viewport& target);
void unbindPixelRays(const MarchInputs& inputs);

} // namespace tetmarch

#endif
