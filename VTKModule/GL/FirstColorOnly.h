// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Restricts drawing to the first colour buffer of the framebuffer.
#ifndef TetMarchGLFirstColorOnly_h
#define TetMarchGLFirstColorOnly_h

#include "vtkOpenGLRenderUtilities.h"

#include <array>
#include <cstddef>

namespace tetmarch
{

/**
 * A render pass may have surfaces write more than their colour, each into a buffer of its own
 * (vtkSSAOPass: positions and normals). A shader that doesn't know of these buffers would leave
 * undefined values there, so they are switched off while this object lives. The framebuffer that is
 * bound for drawing must be the same at its end.
 */
class FirstColorOnly
{
public:
  explicit FirstColorOnly(bool wanted)
  {
    for (std::size_t i = 0; wanted && i < this->Buffers.size(); ++i)
    {
      int buffer = GL_NONE;
      glGetIntegerv(GL_DRAW_BUFFER0 + static_cast<GLenum>(i), &buffer);
      this->Buffers[i] = static_cast<GLenum>(buffer);
      this->Count = buffer == GL_NONE ? this->Count : static_cast<GLsizei>(i + 1);
    }
    if (this->Count > 1)
    {
      // Not through VTK's record of the state, which ignores a change to fewer buffers.
      glDrawBuffers(1, this->Buffers.data());
    }
  }
  ~FirstColorOnly()
  {
    if (this->Count > 1)
    {
      glDrawBuffers(this->Count, this->Buffers.data());
    }
  }
  FirstColorOnly(const FirstColorOnly&) = delete;
  FirstColorOnly& operator=(const FirstColorOnly&) = delete;

private:
  std::array<GLenum, 8> Buffers{}; // as many as any GL 3 has
  GLsizei Count = 0;
};

} // namespace tetmarch

#endif
