// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// An array on the GPU that may have a texel for each tetrahedron. What one texture buffer doesn't
// hold lies in a second one (Shaders/tet/split_cell_buffers.glsl); Mesh/MeshSizes.h has the limits.
#ifndef TetMarchGLCellBuffer_h
#define TetMarchGLCellBuffer_h

#include "GL/TextureBuffer.h"

namespace tetmarch
{

class CellBuffer
{
public:
  using Texels = TextureBuffer::Texels;

  /** Replace the contents. Returns an empty string, or why it can't be done. */
  std::string upload(
    vtkOpenGLRenderWindow* window, TexelFormat format, std::size_t count, const Texels& texels);
  /** Bind to samplers of the program that is in use; to the second one if there are two buffers. */
  void bind(vtkShaderProgram* program, const char* first, const char* second);
  void unbind();
  void release(vtkWindow* window);
  std::size_t bytes() const { return this->First.bytes() + this->Second.bytes(); }
  bool isSplit() const { return this->Second.bytes() > 0; }
  /** How many texels the first buffer has. */
  std::size_t texelsOfFirst() const { return this->FirstTexels; }

private:
  TextureBuffer First;
  TextureBuffer Second;
  std::size_t FirstTexels = 0;
};

} // namespace tetmarch

#endif
