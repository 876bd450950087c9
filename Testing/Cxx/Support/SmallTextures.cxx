// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmallTextures.h"

#include "GLReplacements.h"

#include <algorithm>

namespace tetmarch::testing
{
namespace
{
TextureLimits Limits;
int Made = 0;

// The GL's functions, as they are.
void(GLAPIENTRY* GetIntegerv)(GLenum, GLint*);
PFNGLTEXIMAGE3DPROC TexImage3D;

void GLAPIENTRY getIntegerv(GLenum name, GLint* value)
{
  GetIntegerv(name, value);
  if (name == GL_MAX_ARRAY_TEXTURE_LAYERS)
  {
    *value = std::min(*value, Limits.Layers);
  }
  if (name == GL_MAX_TEXTURE_IMAGE_UNITS)
  {
    *value = std::min(*value, Limits.Units);
  }
}

// What is refused gets a size that the GL itself refuses: a proxy has none then, and a texture is
// an error.
void GLAPIENTRY texImage3D(GLenum target, GLint level, GLint internal, GLsizei width,
  GLsizei height, GLsizei layers, GLint border, GLenum format, GLenum type, const void* data)
{
  const long texels = static_cast<long>(width) * height * layers;
  const bool isTexture = target == GL_TEXTURE_2D_ARRAY;
  const bool refused =
    texels > Limits.Texels || layers > Limits.Layers || (isTexture && Made >= Limits.Textures);
  Made += isTexture && !refused ? 1 : 0;
  TexImage3D(
    target, level, internal, refused ? 1 << 24 : width, height, layers, border, format, type, data);
}

GLReplacements<SmallTextures> Replaced;
} // namespace

SmallTextures::SmallTextures(const TextureLimits& limits)
{
  Limits = limits;
  Made = 0;
  TETMARCH_REPLACE_GL(Replaced, TexImage3D, texImage3D);
  TETMARCH_REPLACE_GL_1(Replaced, GetIntegerv, getIntegerv);
}

SmallTextures::~SmallTextures() { Replaced.restore(); }

int SmallTextures::made() const { return Made; }
} // namespace tetmarch::testing
