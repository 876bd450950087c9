// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whose GL functions the process calls.
 *
 * VTK before 9.4 links libOpenGL and GLEW, and GLEW asks glXGetProcAddressARB. GLFunctions.cxx
 * defines the functions of GL 1.1 and glXGetProcAddressARB once more in the executable, where the
 * dynamic linker finds them first, and forwards each to the backend chosen here.
 */
#ifndef tetmarch_GLFunctions_h
#define tetmarch_GLFunctions_h

namespace tetmarch
{

using GLFunction = void (*)();
using GLFunctionLoader = GLFunction (*)(const char* name);

/**
 * Send every GL call of the process to the functions that loader finds. Until it is called they go
 * where they would go without this library. Returns the loader of before, or nullptr.
 */
GLFunctionLoader SetGLFunctionLoader(GLFunctionLoader loader);

GLFunction FindGLFunction(const char* name);

} // namespace tetmarch

#endif
