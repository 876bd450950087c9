// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The files of Shaders/, compiled in, put together to whole shaders.
#ifndef TetMarchGLShaderSource_h
#define TetMarchGLShaderSource_h

#include <string>

namespace tetmarch
{

/**
 * The text of a shader file for vtkOpenGLShaderCache: the version tag, the defines, the file with
 * its #include lines replaced by the files, each once, under #line directives whose source number
 * is explained by sourceLegend().
 */
std::string shaderSource(const std::string& file, const std::string& defines = {});

/** "0 march.frag.glsl, 1 language.glsl, ...": for messages about compile errors. */
std::string sourceLegend();

} // namespace tetmarch

#endif
