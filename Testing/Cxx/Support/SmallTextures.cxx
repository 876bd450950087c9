// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmallTextures.h"

#include "GLPointers.h"

#if TETMARCH_GL_1_IS_LINKED
#include "GLFunctions.h"
#endif

#include <algorithm>
#include <cstring>

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

#if TETMARCH_GL_1_IS_LINKED

GLFunctionLoader Loader = nullptr;

GLFunction limitedFunction(const char* name)
{
  return std::strcmp(name, "glGetIntegerv") == 0 ? reinterpret_cast<GLFunction>(&getIntegerv)
                                                 : Loader(name);
}

void limitIntegers()
{
  Loader = SetGLFunctionLoader(&limitedFunction);
  GetIntegerv = reinterpret_cast<decltype(GetIntegerv)>(Loader("glGetIntegerv"));
}

void restoreIntegers() { SetGLFunctionLoader(Loader); }

#else

void limitIntegers()
{
  GetIntegerv = TETMARCH_GL_POINTER(GetIntegerv);
  TETMARCH_GL_POINTER(GetIntegerv) = &getIntegerv;
}

void restoreIntegers() { TETMARCH_GL_POINTER(GetIntegerv) = GetIntegerv; }

#endif
} // namespace

SmallTextures::SmallTextures(const TextureLimits& limits)
{
  Limits = limits;
  Made = 0;
  TexImage3D = TETMARCH_GL_POINTER(TexImage3D);
  TETMARCH_GL_POINTER(TexImage3D) = &texImage3D;
  limitIntegers();
}

SmallTextures::~SmallTextures()
{
  restoreIntegers();
  TETMARCH_GL_POINTER(TexImage3D) = TexImage3D;
}

int SmallTextures::made() const { return Made; }
} // namespace tetmarch::testing
