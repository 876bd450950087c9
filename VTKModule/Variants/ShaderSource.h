// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Complete shaders from the embedded files of Shaders/.
#ifndef TetMarchVariantsShaderSource_h
#define TetMarchVariantsShaderSource_h

#include <string>

namespace tetmarch
{

/**
 * The text of a shader file for vtkOpenGLShaderCache: the version tag, the file with its #include
 * lines replaced by the files, each once, without inactive parts (ShaderConditions.h), and with
 * #line directives whose numbers withFileNames() decodes. A faulty condition, such as one with an
 * undefined symbol, becomes an #error.
 */
std::string shaderSource(const std::string& file, const std::string& defines = {});

/**
 * A compiler's messages with "march.glsl:12" in place of "7:12", "7(12)" or "ERROR: 7:12" at the
 * beginning of a line, the formats of various GLs.
 */
std::string withFileNames(const std::string& log);

} // namespace tetmarch

#endif
