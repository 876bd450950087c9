// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ProgramCapture.h"

#include "vtkOpenGLRenderUtilities.h" // the GL

#include <algorithm>
#include <array>
#include <iterator>

namespace tetmarch
{
namespace
{

struct UniformRow
{
  unsigned int Type;
  const char* Name;
  int Numbers;
  bool IsReal; // else integers
};

constexpr UniformRow UniformRows[] = {
  { GL_FLOAT, "float", 1, true },
  { GL_FLOAT_VEC2, "vec2", 2, true },
  { GL_FLOAT_VEC3, "vec3", 3, true },
  { GL_FLOAT_VEC4, "vec4", 4, true },
  { GL_FLOAT_MAT3, "mat3", 9, true },
  { GL_FLOAT_MAT4, "mat4", 16, true },
  { GL_INT, "int", 1, false },
  { GL_INT_VEC3, "ivec3", 3, false },
  { GL_BOOL, "bool", 1, false },
};

struct FormatRow
{
  int InternalFormat;
  const char* Name;
  unsigned int Format;
  int Components;
  unsigned int Type;
  const char* TypeName;
  std::size_t Bytes; // a number
};

constexpr FormatRow FormatRows[] = {
  { GL_R8, "R8", GL_RED, 1, GL_UNSIGNED_BYTE, "uint8", 1 },
  { GL_R16, "R16", GL_RED, 1, GL_UNSIGNED_SHORT, "uint16", 2 },
  { GL_R32F, "R32F", GL_RED, 1, GL_FLOAT, "float32", 4 },
  { GL_RG32F, "RG32F", GL_RG, 2, GL_FLOAT, "float32", 4 },
  { GL_RGBA32F, "RGBA32F", GL_RGBA, 4, GL_FLOAT, "float32", 4 },
  { GL_RGBA16, "RGBA16", GL_RGBA, 4, GL_UNSIGNED_SHORT, "uint16", 2 },
  { GL_RGBA16F, "RGBA16F", GL_RGBA, 4, GL_HALF_FLOAT, "uint16", 2 },
  { GL_R8UI, "R8UI", GL_RED_INTEGER, 1, GL_UNSIGNED_BYTE, "uint8", 1 },
  { GL_R32UI, "R32UI", GL_RED_INTEGER, 1, GL_UNSIGNED_INT, "uint32", 4 },
  { GL_RG32UI, "RG32UI", GL_RG_INTEGER, 2, GL_UNSIGNED_INT, "uint32", 4 },
  { GL_RGBA32UI, "RGBA32UI", GL_RGBA_INTEGER, 4, GL_UNSIGNED_INT, "uint32", 4 },
};

struct SamplerRow
{
  unsigned int Type;
  unsigned int Target;
  unsigned int Binding;
  CapturedTexture::Shape Shape;
};

constexpr SamplerRow SamplerRows[] = {
  { GL_SAMPLER_BUFFER, GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER,
    CapturedTexture::Shape::Buffer },
  { GL_UNSIGNED_INT_SAMPLER_BUFFER, GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER,
    CapturedTexture::Shape::Buffer },
  { GL_SAMPLER_2D, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, CapturedTexture::Shape::Image },
  { GL_SAMPLER_2D_ARRAY, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY,
    CapturedTexture::Shape::ImageArray },
};

template <typename Row, typename Key, std::size_t N>
const Row* rowOf(const Row (&rows)[N], Key Row::*member, Key key)
{
  const auto found = std::find_if(
    std::begin(rows), std::end(rows), [&](const Row& row) { return row.*member == key; });
  return found == std::end(rows) ? nullptr : found;
}

int levelParameter(unsigned int target, unsigned int name)
{
  int value = 0;
  glGetTexLevelParameteriv(target, 0, name, &value);
  return value;
}

// The buffer of the bound buffer texture: see TextureBuffer::isAttached().
unsigned int attachedBuffer()
{
  int handle = -1;
  glGetTexLevelParameteriv(GL_TEXTURE_BUFFER, 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &handle);
  if (handle < 0)
  {
    glGetIntegerv(GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &handle);
  }
  return static_cast<unsigned int>(handle);
}

void readBuffer(std::size_t texelBytes, CapturedTexture& texture)
{
  int before = 0;
  glGetIntegerv(GL_TEXTURE_BUFFER, &before); // the binding point of buffers has the same name
  GLint64 bytes = 0;
  glBindBuffer(GL_TEXTURE_BUFFER, attachedBuffer());
  glGetBufferParameteri64v(GL_TEXTURE_BUFFER, GL_BUFFER_SIZE, &bytes);
  texture.Bytes.resize(static_cast<std::size_t>(bytes));
  texture.Width = static_cast<int>(texture.Bytes.size() / texelBytes);
  glGetBufferSubData(GL_TEXTURE_BUFFER, 0, bytes, texture.Bytes.data());
  glBindBuffer(GL_TEXTURE_BUFFER, static_cast<unsigned int>(before));
}

void readImage(unsigned int target, const FormatRow& row, CapturedTexture& texture)
{
  texture.Width = levelParameter(target, GL_TEXTURE_WIDTH);
  texture.Height = levelParameter(target, GL_TEXTURE_HEIGHT);
  texture.Layers = target == GL_TEXTURE_2D ? 1 : levelParameter(target, GL_TEXTURE_DEPTH);
  texture.Bytes.resize(
    static_cast<std::size_t>(row.Components) * row.Bytes * static_cast<std::size_t>(texture.Width) *
    static_cast<std::size_t>(texture.Height) * static_cast<std::size_t>(texture.Layers));
  int alignment = 4;
  glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(target, 0, row.Format, row.Type, texture.Bytes.data());
  glPixelStorei(GL_PACK_ALIGNMENT, alignment);
}

CapturedUniform uniformOf(
  unsigned int program, const std::string& name, const UniformRow& row, int count)
{
  CapturedUniform uniform;
  uniform.Type = row.Name;
  for (int i = 0; i < count; ++i)
  {
    const std::string element = count > 1 ? name + "[" + std::to_string(i) + "]" : name;
    const int location = glGetUniformLocation(program, element.c_str());
    std::array<float, 16> reals{};
    std::array<int, 16> integers{};
    row.IsReal ? glGetUniformfv(program, location, reals.data())
               : glGetUniformiv(program, location, integers.data());
    for (int k = 0; k < row.Numbers; ++k)
    {
      uniform.Values.push_back(row.IsReal ? double(reals[k]) : double(integers[k]));
    }
  }
  return uniform;
}

// Returns false if the format is unknown.
bool readTexture(
  unsigned int program, const std::string& name, const SamplerRow& row, CapturedTexture& texture)
{
  int unit = 0;
  glGetUniformiv(program, glGetUniformLocation(program, name.c_str()), &unit);
  int before = GL_TEXTURE0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &before);
  glActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(unit));
  const FormatRow* format = rowOf(
    FormatRows, &FormatRow::InternalFormat, levelParameter(row.Target, GL_TEXTURE_INTERNAL_FORMAT));
  if (format)
  {
    texture.Kind = row.Shape;
    texture.Format = format->Name;
    texture.Components = format->Components;
    texture.Type = format->TypeName;
    row.Shape == CapturedTexture::Shape::Buffer
      ? readBuffer(static_cast<std::size_t>(format->Components) * format->Bytes, texture)
      : readImage(row.Target, *format, texture);
  }
  glActiveTexture(static_cast<unsigned int>(before));
  return format != nullptr;
}

} // namespace

std::string CapturedProgram::add(unsigned int program)
{
  int count = 0;
  glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
  for (int i = 0; i < count; ++i)
  {
    std::array<char, 256> text{};
    int elements = 0;
    unsigned int type = 0;
    glGetActiveUniform(program, static_cast<unsigned int>(i), static_cast<int>(text.size()),
      nullptr, &elements, &type, text.data());
    const std::string name = std::string(text.data()).substr(0, std::string(text.data()).find('['));
    const UniformRow* uniform = rowOf(UniformRows, &UniformRow::Type, type);
    if (uniform && this->Uniforms.count(name) == 0)
    {
      this->Uniforms[name] = uniformOf(program, name, *uniform, elements);
    }
    const SamplerRow* sampler = rowOf(SamplerRows, &SamplerRow::Type, type);
    for (int k = 0; sampler && k < elements; ++k)
    {
      const std::string element = elements > 1 ? name + "[" + std::to_string(k) + "]" : name;
      if (this->Textures.count(element) == 0 &&
          !readTexture(program, element, *sampler, this->Textures[element]))
      {
        return "The texture " + element + " has a format that is not captured.";
      }
    }
  }
  return {};
}

} // namespace tetmarch
