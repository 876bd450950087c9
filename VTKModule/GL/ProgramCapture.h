// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Everything that a program of the GL reads: its uniforms and textures by name. The GL is asked, so
// that whatever a picture needs is captured without a list of it.
#ifndef TetMarchGLProgramCapture_h
#define TetMarchGLProgramCapture_h

#include <map>
#include <string>
#include <vector>

namespace tetmarch
{

struct CapturedUniform
{
  std::string Type; // of GLSL: "float", "ivec3", "mat4", ...
  /** The elements of an array consecutively; matrices column by column. */
  std::vector<double> Values;
};

struct CapturedTexture
{
  enum class Shape
  {
    Buffer, // Width texels, Height = Layers = 1
    Image,
    ImageArray
  };
  Shape Kind = Shape::Buffer;
  std::string Format; // "R8", "R16", "RGBA32F", "RG32UI", ...: Components of Type
  int Components = 1;
  std::string Type; // "uint8", "uint16", "uint32" or "float32"
  int Width = 0;
  int Height = 1;
  int Layers = 1;
  std::vector<unsigned char> Bytes;
};

struct CapturedProgram
{
  std::map<std::string, CapturedUniform> Uniforms; // "name" for an array name[]
  std::map<std::string, CapturedTexture> Textures; // "name" or, in an array of samplers, "name[1]"

  /**
   * Add the uniforms and textures of the program in use, whose textures are bound, unless there is
   * one of that name already. The contents of textures are read back from the GPU. Returns an empty
   * string, or which texture has an unknown format.
   */
  std::string add(unsigned int program);
};

} // namespace tetmarch

#endif
