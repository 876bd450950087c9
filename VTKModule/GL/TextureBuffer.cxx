// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/TextureBuffer.h"

#include "GL/ErrorQueue.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

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

} // namespace

std::string TextureBuffer::upload(
  vtkOpenGLRenderWindow* window, TexelFormat format, const void* data, std::size_t texels)
{
  if (texels == 0) // a texture has a texel at least
  {
    const std::array<std::uint32_t, 4> none{};
    return this->upload(window, format, none.data(), 1);
  }
  const FormatRow row = rowOf(format);
  const std::size_t bytes = texels * row.Bytes;
  clearErrors();
  // The texture refers to the storage of the buffer, which an upload may replace: make the texture
  // again.
  this->release(window);
  const bool uploaded = this->Buffer->Upload(
    static_cast<const unsigned char*>(data), bytes, vtkOpenGLBufferObject::TextureBuffer);
  if (!uploaded || glGetError() != GL_NO_ERROR)
  {
    this->release(window);
    return "The GPU has no room for a buffer of " + std::to_string(bytes) +
           " bytes. Close what else uses it, or extract or coarsen a part of the grid.";
  }
  this->Texture->SetContext(window);
  this->Texture->SetInternalFormat(row.InternalFormat);
  this->Texture->SetFormat(row.Format);
  if (!this->Texture->CreateTextureBuffer(
        static_cast<unsigned int>(texels), row.Components, row.Type, this->Buffer) ||
      !this->isAttached() || glGetError() != GL_NO_ERROR)
  {
    this->release(window);
    return "The GL makes no texture of a buffer of " + std::to_string(texels) + " texels.";
  }
  this->Bytes = bytes;
  return {};
}

// VTK may have taken the error from the queue.
bool TextureBuffer::isAttached()
{
  int handle = 0;
  this->Texture->Activate();
  glGetIntegerv(GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &handle);
  this->Texture->Deactivate();
  return handle == this->Buffer->GetHandle();
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

std::size_t mostTexels()
{
  int most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  return static_cast<std::size_t>(most);
}

} // namespace tetmarch
