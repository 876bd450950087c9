// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Counts what the current GL context holds, to see what is left behind
 */
#ifndef tetmarch_testing_GLObjects_h
#define tetmarch_testing_GLObjects_h

#include "vtkOpenGLRenderUtilities.h"

#include <array>

namespace tetmarch::testing
{
/// Textures, buffers, framebuffers, vertex arrays, renderbuffers.
inline std::array<int, 5> countGLObjects()
{
  std::array<int, 5> counts{};
  for (GLuint name = 1; name < 4096; ++name)
  {
    counts[0] += glIsTexture(name);
    counts[1] += glIsBuffer(name);
    counts[2] += glIsFramebuffer(name);
    counts[3] += glIsVertexArray(name);
    counts[4] += glIsRenderbuffer(name);
  }
  return counts;
}

/// Shaders and programs. Each variant that is compiled stays in the window's cache.
inline int countShaders()
{
  int count = 0;
  for (GLuint name = 1; name < 4096; ++name)
  {
    count += glIsShader(name) + glIsProgram(name);
  }
  return count;
}
} // namespace tetmarch::testing

#endif
