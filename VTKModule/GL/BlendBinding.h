// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the blend modes need becomes uniforms.
#ifndef TetMarchGLBlendBinding_h
#define TetMarchGLBlendBinding_h

class vtkShaderProgram;

namespace tetmarch
{

struct Blending;
struct VariantKey;

/** What Shaders/gather/blend_buffers.glsl declares. */
void bindBlending(vtkShaderProgram* program, const Blending& blending, const VariantKey& key);

} // namespace tetmarch

#endif
