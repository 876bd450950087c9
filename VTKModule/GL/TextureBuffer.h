// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// An array on the GPU that shaders read by index.
#ifndef TetMarchGLTextureBuffer_h
#define TetMarchGLTextureBuffer_h

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkTextureObject.h"

#include <cstddef>
#include <functional>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace tetmarch
{

enum class TexelFormat
{
  R8UI,
  R32F,
  RG32F,
  RGBA16F,
  RGBA32F,
  R32UI,
  RG32UI,
  RGBA32UI
};

class TextureBuffer
{
public:
  /** The texels from begin to end; they stay until it is called again. */
  using Texels = std::function<const void*(std::size_t begin, std::size_t end)>;

  /** Replace the contents by texels that are made and copied a million at a time, so that no second
   * copy of the whole is needed. Behind them is room for more. Returns an empty string, or why it
   * can't be done. */
  std::string upload(vtkOpenGLRenderWindow* window, TexelFormat format, std::size_t count,
    const Texels& texels, std::size_t room = 0);
  /** The same of an array; one texel of zeros if it is empty. */
  std::string upload(vtkOpenGLRenderWindow* window, TexelFormat format, const void* data,
    std::size_t texels, std::size_t room = 0);
  /** Replace a part of the contents, from a byte on. */
  void replace(std::size_t begin, const void* data, std::size_t bytes);
  /** Bind to a sampler of the program that is in use. */
  void bind(vtkShaderProgram* program, const char* sampler);
  void unbind();
  void release(vtkWindow* window);
  std::size_t bytes() const { return this->Bytes; }

private:
  bool allocate(std::size_t bytes);
  bool isAttached();

  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
  std::size_t Bytes = 0;
};

} // namespace tetmarch

#endif
