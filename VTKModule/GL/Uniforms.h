// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Sets uniforms: matrices from double, row by row, to float, column by column, and texture units.
#ifndef TetMarchGLUniforms_h
#define TetMarchGLUniforms_h

#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <array>

namespace tetmarch
{

inline void setUniform(vtkShaderProgram* program, const char* name, const std::array<double, 16>& m)
{
  std::array<float, 16> columns;
  for (int i = 0; i < 16; ++i)
  {
    columns[i] = static_cast<float>(m[4 * (i % 4) + i / 4]);
  }
  program->SetUniformMatrix4x4(name, columns.data());
}

inline void setUniform(vtkShaderProgram* program, const char* name, const std::array<double, 9>& m)
{
  std::array<float, 9> columns;
  for (int i = 0; i < 9; ++i)
  {
    columns[i] = static_cast<float>(m[3 * (i % 3) + i / 3]);
  }
  program->SetUniformMatrix3x3(name, columns.data());
}

inline void setUniform(vtkShaderProgram* program, const char* name, const std::array<double, 4>& v)
{
  const std::array<float, 4> values{ { static_cast<float>(v[0]), static_cast<float>(v[1]),
    static_cast<float>(v[2]), static_cast<float>(v[3]) } };
  program->SetUniform4f(name, values.data());
}

inline void bindImage(vtkShaderProgram* program, const char* sampler, vtkTextureObject* texture)
{
  texture->Activate();
  program->SetUniformi(sampler, texture->GetTextureUnit());
}

} // namespace tetmarch

#endif
