// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The text of a shader as GLSL 4.50 core, for compilers that are no GL's
 */
#ifndef tetmarch_testing_CoreGlsl_h
#define tetmarch_testing_CoreGlsl_h

#include <string>

namespace tetmarch::testing
{
inline void replaceAll(std::string& text, const std::string& tag, const std::string& by)
{
  for (std::size_t at = text.find(tag); at != std::string::npos;
       at = text.find(tag, at + by.size()))
  {
    text.replace(at, tag.size(), by);
  }
}

/// A text with the outputs of newer GLSL.
inline std::string withOutputs(std::string text)
{
  std::string outputs;
  for (int i = 0; i < 4; ++i)
  {
    const std::string number = std::to_string(i);
    const std::string old = "gl_FragData[" + number + "]";
    if (text.find(old) != std::string::npos)
    {
      outputs += "layout(location = " + number + ") out vec4 fragOutput" + number + ";\n";
      replaceAll(text, old, "fragOutput" + number);
    }
  }
  replaceAll(text, "//VTK::Output::Dec", outputs);
  return text;
}

/// What shaderSource() made, with what VTK puts in the place of the tags, as GLSL 4.50. Of a peeled
/// picture VTK's text calls castRay() for one or two parts of a ray: here for one.
inline std::string asCoreGlsl(std::string text)
{
  text = withOutputs(text);
  // What these add to GLSL 1.50 is part of 4.50.
  replaceAll(text, "#extension GL_ARB_gpu_shader5 : require\n", "\n");
  replaceAll(text, "#extension GL_ARB_ES3_1_compatibility : require\n", "\n");
  replaceAll(text, "#extension GL_ARB_texture_gather : require\n", "\n");
  replaceAll(text, "//VTK::System::Dec", "#version 450 core");
  replaceAll(text, "//VTK::DepthPeeling::Dec", "layout(location = 0) out vec4 peeled;");
  replaceAll(text, "//VTK::CallWorker::Impl",
    "initializeRayCast();\n  peeled = castRay(0.0, 1.0) + vec4(in_inverseWindowSize, "
    "g_opacityThreshold, 0.0);");
  return text;
}

/// What shaderSource() made with TETMARCH_ES, as Web/shader_source.js completes it.
inline std::string asWebGlsl(std::string text)
{
  std::string head = "#version 300 es\n";
  for (const char* type : { "float", "int", "sampler2D", "usampler2D", "sampler2DArray" })
  {
    head += std::string("precision highp ") + type + ";\n";
  }
  text = withOutputs(text);
  replaceAll(text, "//VTK::System::Dec", head + "#define BUFFER_ROW_SHIFT 12\n");
  return text;
}
} // namespace tetmarch::testing

#endif
