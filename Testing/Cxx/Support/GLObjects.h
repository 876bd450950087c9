// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Counts what the current GL context holds, to see what is left behind
 */
#ifndef tetmarch_testing_GLObjects_h
#define tetmarch_testing_GLObjects_h

#include "vtkOpenGLRenderUtilities.h"

#include <algorithm>
#include <array>

namespace tetmarch::testing
{
/// Names up to this one are tried at least. Some GLs use freed names again, others count on.
constexpr GLuint LeastNames = 4096;

template <typename Generate, typename Delete, typename Is>
int countNames(const Generate& generate, const Delete& destroy, const Is& is)
{
  GLuint next = 0;
  generate(1, &next);
  destroy(1, &next);
  int count = 0;
  for (GLuint name = 1; name < std::max(LeastNames, next); ++name)
  {
    count += is(name);
  }
  return count;
}

/// Textures, buffers, framebuffers, vertex arrays, renderbuffers.
inline std::array<int, 5> countGLObjects()
{
  return { { countNames(glGenTextures, glDeleteTextures, glIsTexture),
    countNames(glGenBuffers, glDeleteBuffers, glIsBuffer),
    countNames(glGenFramebuffers, glDeleteFramebuffers, glIsFramebuffer),
    countNames(glGenVertexArrays, glDeleteVertexArrays, glIsVertexArray),
    countNames(glGenRenderbuffers, glDeleteRenderbuffers, glIsRenderbuffer) } };
}

/// Shaders and programs. Each variant that is compiled stays in the window's cache.
inline int countShaders()
{
  return countNames([](GLsizei, GLuint* name) { *name = glCreateProgram(); },
    [](GLsizei, const GLuint* name) { glDeleteProgram(*name); },
    [](GLuint name) { return glIsShader(name) + glIsProgram(name); });
}
} // namespace tetmarch::testing

#endif
