// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ArrayTexture.h"

#include "GL/ErrorQueue.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <string>

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

std::string describe(const std::array<int, 3>& sizes)
{
  return std::to_string(sizes[0]) + " x " + std::to_string(sizes[1]) + " x " +
         std::to_string(sizes[2]);
}

} // namespace

std::string ArrayTexture::upload(
  vtkOpenGLRenderWindow* window, const std::array<int, 3>& sizes, const StoredValues& values)
{
  this->release(window);
  const std::array<int, 3> most = mostLayers();
  if (sizes[0] > most[0] || sizes[1] > most[1] || sizes[2] > most[2])
  {
    return "The volume has " + describe(sizes) + " values, but the GPU takes " + describe(most) +
           " at most. Extract a part of it, or coarsen it.";
  }
  const FormatRow row = rowOf(values.Type);
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
    row.Type, values.Data);
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
  const bool sound = glGetError() == GL_NO_ERROR;
  int width = 0; // 0 if a VTK that reports errors has taken the error from the queue
  glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_WIDTH, &width);
  this->unbind();
  if (!sound || width != sizes[0])
  {
    this->release(window);
    return "The GPU has no room for a texture of " + std::to_string(values.bytes()) +
           " bytes. Close what else uses it, or extract or coarsen a part of the volume.";
  }
  this->Bytes = values.bytes();
  return {};
}

void ArrayTexture::bind(vtkShaderProgram* program, const char* sampler)
{
  if (this->Unit < 0)
  {
    this->Unit = this->Window->GetTextureUnitManager()->Allocate();
  }
  this->Window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Handle);
  program->SetUniformi(sampler, this->Unit);
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

} // namespace tetmarch
