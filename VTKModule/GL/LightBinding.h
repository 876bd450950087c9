// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Lights become uniforms.
#ifndef TetMarchGLLightBinding_h
#define TetMarchGLLightBinding_h

class vtkShaderProgram;

namespace tetmarch
{

struct LightUniforms;
struct VariantKey;

/** What Shaders/light/light_buffers.glsl declares. */
void bindLights(vtkShaderProgram* program, const LightUniforms& lights, const VariantKey& key);

/** What Shaders/light/light_ray_buffers.glsl declares. */
void bindLightRays(vtkShaderProgram* program, const LightUniforms& lights, const VariantKey& key);

} // namespace tetmarch

#endif
