// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The files of Shaders/, compiled in, put together to whole shaders.
#ifndef TetMarchVariantsShaderSource_h
#define TetMarchVariantsShaderSource_h

#include <string>

namespace tetmarch
{

/**
 * The text of a shader file for vtkOpenGLShaderCache: the version tag, the file with
 * its #include lines replaced by the files, each once, and without what its conditions leave out
 * (ShaderConditions.h), under #line directives with numbers that withFileNames() knows. A faulty
 * condition, as one of a symbol that neither the defines nor the files know, becomes an #error.
 */
std::string shaderSource(const std::string& file, const std::string& defines = {});

/**
 * A compiler's messages with "march.glsl:12" where they begin a line with "7:12", "7(12)" or
 * "ERROR: 7:12", as those of various GLs do.
 */
std::string withFileNames(const std::string& log);

} // namespace tetmarch

#endif
