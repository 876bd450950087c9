// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ArrayTexture.h"

#include "GL/ErrorQueue.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

struct FormatRow
{
  int InternalFormat;
  unsigned int Type;
};

FormatRow rowOf(ValueType type)
{
  return type == ValueType::UInt8    ? FormatRow{ GL_R8, GL_UNSIGNED_BYTE }
         : type == ValueType::UInt16 ? FormatRow{ GL_R16, GL_UNSIGNED_SHORT }
                                     : FormatRow{ GL_R32F, GL_FLOAT };
}

// Whether the GL would make a texture of that size; it is asked, and nothing is allocated.
bool takes(int width, int height, int layers, const FormatRow& row)
{
  glTexImage3D(GL_PROXY_TEXTURE_2D_ARRAY, 0, row.InternalFormat, width, height, layers, 0, GL_RED,
    row.Type, nullptr);
  int taken = 0;
  glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_WIDTH, &taken);
  return taken == width;
}

} // namespace

bool ArrayTexture::upload(vtkOpenGLRenderWindow* window, const std::array<int, 3>& sizes,
  ValueType type, const void* values)
{
  this->release(window);
  const FormatRow row = rowOf(type);
  vtkOpenGLState* state = window->GetState();
  clearErrors();
  glGenTextures(1, &this->Handle);
  this->Window = window;
  this->Unit = window->GetTextureUnitManager()->Allocate();
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Handle);
  for (const auto& [parameter, value] : { std::pair{ GL_TEXTURE_MIN_FILTER, GL_NEAREST },
         { GL_TEXTURE_MAG_FILTER, GL_NEAREST }, { GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE },
         { GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE }, { GL_TEXTURE_MAX_LEVEL, 0 } })
  {
    glTexParameteri(GL_TEXTURE_2D_ARRAY, parameter, value);
  }
  int alignment = 4;
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, row.InternalFormat, sizes[0], sizes[1], sizes[2], 0, GL_RED,
    row.Type, values);
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
  const bool sound = glGetError() == GL_NO_ERROR;
  int width = 0; // 0 if a VTK that reports errors has taken the error from the queue
  glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_WIDTH, &width);
  this->unbind();
  if (!sound || width != sizes[0])
  {
    this->release(window);
    return false;
  }
  this->Bytes = StoredValues::sizeOf(type) * static_cast<std::size_t>(sizes[0]) *
                static_cast<std::size_t>(sizes[1]) * static_cast<std::size_t>(sizes[2]);
  return true;
}

void ArrayTexture::bind(vtkShaderProgram* program, const char* sampler)
{
  program->SetUniformi(sampler, this->activate());
}

int ArrayTexture::activate()
{
  if (this->Unit < 0)
  {
    this->Unit = this->Window->GetTextureUnitManager()->Allocate();
  }
  this->Window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Handle);
  return this->Unit;
}

void ArrayTexture::unbind()
{
  if (this->Unit >= 0)
  {
    this->Window->GetState()->vtkglActiveTexture(
      GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    this->Window->GetTextureUnitManager()->Free(this->Unit);
    this->Unit = -1;
  }
}

void ArrayTexture::release(vtkWindow* window)
{
  if (this->Handle != 0 && window)
  {
    this->unbind();
    glDeleteTextures(1, &this->Handle);
  }
  this->Handle = 0;
  this->Bytes = 0;
}

std::array<int, 3> mostLayers()
{
  std::array<int, 3> most{};
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most[0]);
  most[1] = most[0];
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most[2]);
  return most;
}

int layersTaken(const std::array<int, 3>& sizes, ValueType type)
{
  const FormatRow row = rowOf(type);
  int taken = 0;
  int refused = std::min(sizes[2], mostLayers()[2]) + 1;
  // Most volumes are taken as they are.
  for (int layers = refused - 1; refused - taken > 1; layers = taken + (refused - taken) / 2)
  {
    int& bound = takes(sizes[0], sizes[1], layers, row) ? taken : refused;
    bound = layers;
  }
  clearErrors();
  return taken;
}

} // namespace tetmarch
