// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The pointers that VTK calls the GL by, so that a test can put another function in between
 */
#ifndef tetmarch_testing_GLPointers_h
#define tetmarch_testing_GLPointers_h

#include "vtkOpenGLRenderUtilities.h"

// TETMARCH_GL_POINTER(ShaderSource) is that to glShaderSource. Of functions of GL 1.1, which
// programs link, GLEW has none; glad has all.
#if __has_include("vtk_glew.h")
#define TETMARCH_GL_POINTER(name) __glew##name
#define TETMARCH_GL_1_IS_LINKED 1
#else
#define TETMARCH_GL_1_IS_LINKED 0
#define TETMARCH_GL_POINTER(name) glad_gl##name
#endif

#endif
