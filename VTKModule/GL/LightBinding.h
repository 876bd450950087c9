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

/** What Shaders/light/effect_buffers.glsl declares of lights. */
void bindLights(vtkShaderProgram* program, const LightUniforms& lights, const VariantKey& key);

/** What Shaders/light/light_buffers.glsl declares of rays along those of the picture. */
void bindSampledRays(vtkShaderProgram* program, const LightUniforms& lights);

/** What it declares of rays from vertices: to the lights, unless shadows are sampled, and for the
 * occlusion. */
void bindVertexRays(vtkShaderProgram* program, const LightUniforms& lights, bool toLights);

} // namespace tetmarch

#endif
