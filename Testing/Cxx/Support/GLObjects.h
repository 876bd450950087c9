// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Counts what the current GL context holds, to see what is left behind
 */
#ifndef tetmarch_testing_GLObjects_h
#define tetmarch_testing_GLObjects_h

#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureUnitManager.h"

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
/// Units of textures that VTK counts as taken.
inline int unitsInUse(vtkRenderWindow* window)
{
  vtkTextureUnitManager* units =
    vtkOpenGLRenderWindow::SafeDownCast(window)->GetTextureUnitManager();
  int count = 0;
  for (int unit = 0; unit < units->GetNumberOfTextureUnits(); ++unit)
  {
    count += units->IsAllocated(unit) ? 1 : 0;
  }
  return count;
}
} // namespace tetmarch::testing

#endif
