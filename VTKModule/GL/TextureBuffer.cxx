// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/TextureBuffer.h"

#include "GL/Driver.h"
#include "GL/ErrorQueue.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tetmarch
{
namespace
{

struct FormatRow
{
  unsigned int InternalFormat;
  unsigned int Format;
  std::size_t Bytes; // a texel
  int Components;
  int Type;
};

FormatRow rowOf(TexelFormat format)
{
  switch (format)
  {
    case TexelFormat::R8UI:
      return { GL_R8UI, GL_RED_INTEGER, 1, 1, VTK_UNSIGNED_CHAR };
    case TexelFormat::R32F:
      return { GL_R32F, GL_RED, 4, 1, VTK_FLOAT };
    case TexelFormat::RG32F:
      return { GL_RG32F, GL_RG, 8, 2, VTK_FLOAT };
    case TexelFormat::RGBA16F:
      return { GL_RGBA16F, GL_RGBA, 8, 4, VTK_FLOAT };
    case TexelFormat::RGBA32F:
      return { GL_RGBA32F, GL_RGBA, 16, 4, VTK_FLOAT };
    case TexelFormat::R32UI:
      return { GL_R32UI, GL_RED_INTEGER, 4, 1, VTK_UNSIGNED_INT };
    case TexelFormat::RG32UI:
      return { GL_RG32UI, GL_RG_INTEGER, 8, 2, VTK_UNSIGNED_INT };
    default:
      return { GL_RGBA32UI, GL_RGBA_INTEGER, 16, 4, VTK_UNSIGNED_INT };
  }
}

constexpr std::size_t TexelsOfSlice = std::size_t(1) << 20;

} // namespace

std::string TextureBuffer::upload(vtkOpenGLRenderWindow* window, TexelFormat format,
  const void* data, std::size_t texels, std::size_t room)
{
  const std::array<std::uint32_t, 4> none{};
  const auto* bytes = static_cast<const unsigned char*>(texels > 0 ? data : none.data());
  return this->upload(
    window, format, std::max<std::size_t>(texels, 1),
    [&](std::size_t begin, std::size_t) { return bytes + begin * rowOf(format).Bytes; }, room);
}

void TextureBuffer::replace(std::size_t begin, const void* data, std::size_t bytes)
{
  this->Buffer->Bind();
  glBufferSubData(
    GL_TEXTURE_BUFFER, static_cast<GLintptr>(begin), static_cast<GLsizeiptr>(bytes), data);
  this->Buffer->Release();
}

// The storage of the buffer; what is in it is undefined.
bool TextureBuffer::allocate(std::size_t bytes)
{
  if (!this->Buffer->GenerateBuffer(vtkOpenGLBufferObject::TextureBuffer) || !this->Buffer->Bind())
  {
    return false;
  }
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STATIC_DRAW);
  // A VTK that is built to report errors has already taken the error from the queue.
  GLint64 there = 0;
  glGetBufferParameteri64v(GL_TEXTURE_BUFFER, GL_BUFFER_SIZE, &there);
  return glGetError() == GL_NO_ERROR && there == static_cast<GLint64>(bytes);
}

std::string TextureBuffer::upload(vtkOpenGLRenderWindow* window, TexelFormat format,
  std::size_t texels, const Texels& slice, std::size_t room)
{
  const std::size_t all = texels + room;
  if (const std::size_t most = mostTexels(); all > most)
  {
    return "The GL takes " + std::to_string(most) + " texels in a texture buffer, but " +
           std::to_string(all) + " are needed. Extract or coarsen a part of the grid.";
  }
  const FormatRow row = rowOf(format);
  const std::size_t bytes = all * row.Bytes;
  clearErrors();
  // The texture refers to the storage of the buffer, which an upload may replace: make the texture
  // again.
  this->release(window);
  bool uploaded = this->allocate(bytes);
  for (std::size_t begin = 0; uploaded && begin < texels; begin += TexelsOfSlice)
  {
    const std::size_t end = std::min(begin + TexelsOfSlice, texels);
    const void* data = slice(begin, end);
    glBufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(begin * row.Bytes),
      static_cast<GLsizeiptr>((end - begin) * row.Bytes), data);
    uploaded = glGetError() == GL_NO_ERROR;
  }
  if (!uploaded)
  {
    this->release(window);
    return "The GPU has no room for a buffer of " + std::to_string(bytes) +
           " bytes. Close what else uses it, or extract or coarsen a part of the grid.";
  }
  this->Texture->SetContext(window);
  this->Texture->SetInternalFormat(row.InternalFormat);
  this->Texture->SetFormat(row.Format);
  if (!this->Texture->CreateTextureBuffer(
        static_cast<unsigned int>(all), row.Components, row.Type, this->Buffer) ||
      !this->isAttached() || glGetError() != GL_NO_ERROR)
  {
    this->release(window);
    return "The GL makes no texture of a buffer of " + std::to_string(all) + " texels.";
  }
  this->Bytes = bytes;
  return {};
}

// VTK may have taken the error from the queue. Up to OpenGL 3.0 and its extension a context has the
// answer, from 3.1 on a level of the texture; a query that a driver refuses leaves the value as it
// is. A driver that refuses both is believed to have attached the buffer.
bool TextureBuffer::isAttached()
{
  constexpr int unknown = -1;
  int handle = unknown;
  this->Texture->Activate();
  glGetTexLevelParameteriv(GL_TEXTURE_BUFFER, 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &handle);
  if (handle == unknown)
  {
    glGetIntegerv(GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &handle);
    clearErrors();
  }
  this->Texture->Deactivate();
  return handle == unknown || handle == this->Buffer->GetHandle();
}

void TextureBuffer::bind(vtkShaderProgram* program, const char* sampler)
{
  this->Texture->Activate();
  program->SetUniformi(sampler, this->Texture->GetTextureUnit());
}

void TextureBuffer::unbind() { this->Texture->Deactivate(); }

void TextureBuffer::release(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Buffer->ReleaseGraphicsResources();
  this->Bytes = 0;
}

} // namespace tetmarch
