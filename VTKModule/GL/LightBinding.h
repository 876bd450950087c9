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

/** What Shaders/effect_buffers.glsl declares of lights. */
void bindLights(vtkShaderProgram* program, const LightUniforms& lights, const VariantKey& key);

/** What Shaders/light_buffers.glsl declares but for the occlusion. */
void bindLightRays(vtkShaderProgram* program, const LightUniforms& lights);

/** The rest of it. */
void bindOcclusion(vtkShaderProgram* program, const LightUniforms& lights);

} // namespace tetmarch

#endif
