// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// An array on the GPU that shaders read by index.
#ifndef TetMarchGLTextureBuffer_h
#define TetMarchGLTextureBuffer_h

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkTextureObject.h"

#include <cstddef>
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
  /** Replace the contents; by one texel of zeros if there are none. Returns an empty string, or why
   * it can't be done. */
  std::string upload(
    vtkOpenGLRenderWindow* window, TexelFormat format, const void* data, std::size_t texels);
  /** Bind to a sampler of the program that is in use. */
  void bind(vtkShaderProgram* program, const char* sampler);
  void unbind();
  void release(vtkWindow* window);
  std::size_t bytes() const { return this->Bytes; }

private:
  bool isAttached();

  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
  std::size_t Bytes = 0;
};

/** GL_MAX_TEXTURE_BUFFER_SIZE of the current context. */
std::size_t mostTexels();

} // namespace tetmarch

#endif
