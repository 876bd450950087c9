// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws one triangle over the GL's viewport, for passes that compute each pixel from textures.
#ifndef TetMarchGLFullViewDraw_h
#define TetMarchGLFullViewDraw_h

#include "GL/ShaderDraw.h"
#include "GL/Uniforms.h"

#include <string>
#include <utility>
#include <vector>

namespace tetmarch
{

/** Textures, each with the name of its sampler. */
using NamedTextures = std::vector<std::pair<const char*, vtkTextureObject*>>;

/** With a fragment shader of Shaders/passes. setUniforms(program) sets what is no texture. Returns
 * an empty string, or what is wrong with the shader. */
template <typename SetUniforms>
std::string drawFullView(ShaderDraw& draw, vtkOpenGLRenderWindow* window, const char* file,
  const NamedTextures& textures, const SetUniforms& setUniforms)
{
  std::string error;
  vtkShaderProgram* program = draw.use(window, "passes/full_view.vert.glsl", file, {}, error);
  if (program)
  {
    setUniforms(program);
    for (const auto& [name, texture] : textures)
    {
      bindImage(program, name, texture);
    }
    draw.drawTriangles(1);
    for (const auto& [name, texture] : textures)
    {
      texture->Deactivate();
    }
  }
  return error;
}

} // namespace tetmarch

#endif
