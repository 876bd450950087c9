// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/TableTextures.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

namespace tetmarch
{

std::string TableTextures::upload(vtkOpenGLRenderWindow* window, const IntegralTable& table)
{
  const std::size_t size = table.Values.size();
  std::string error = this->Values.upload(window, TexelFormat::RGBA32F, table.Values.data(), size);
  if (error.empty())
  {
    error = this->Integrals.upload(window, TexelFormat::RGBA32UI, table.Integrals.data(), size);
  }
  if (error.empty())
  {
    error = this->Variations.upload(window, TexelFormat::R32F, table.Variations.data(), size);
  }
  return error;
}

void TableTextures::bind(vtkShaderProgram* program, const IntegralTable& table,
  const ScalarRange& range, const AccuracyLevel& level, const VariantKey& key)
{
  if (key.isComposite() || key.Isosurfaces)
  {
    program->SetUniformf("errorTolerance", static_cast<float>(level.ErrorTolerance));
  }
  if (key.Isosurfaces)
  {
    return;
  }
  this->Values.bind(program, "tableValueBuffer");
  program->SetUniformi("tableSize", table.size());
  program->SetUniformf("tableScale", static_cast<float>(table.scale(range.width())));
  program->SetUniformf("tableOffset", static_cast<float>(table.offset(range.Low)));
  if (key.TransparentRanges)
  {
    program->SetUniform4f("transparentRanges", table.Traits.Transparent.data());
  }
  if (key.ConstantColor)
  {
    program->SetUniform3f("constantColor", table.Values.front().data());
  }
  if (key.NanShown)
  {
    program->SetUniform4f("nanColor", table.NanColor.data());
  }
  if (key.PointScalars)
  {
    this->Integrals.bind(program, "tableIntegralBuffer");
    std::array<float, 4> unit;
    for (int k = 0; k < 4; ++k)
    {
      unit[k] = static_cast<float>(table.IntegralUnit[k]);
    }
    program->SetUniform4f("tableIntegralUnit", unit.data());
  }
  if (key.hasErrorBound())
  {
    this->Variations.bind(program, "tableVariationBuffer");
  }
  if (key.Adaptive)
  {
    program->SetUniformi("mostTrials", level.MostTrials);
  }
}

void TableTextures::unbind()
{
  this->Values.unbind();
  this->Integrals.unbind();
  this->Variations.unbind();
}

void TableTextures::release(vtkWindow* window)
{
  this->Values.release(window);
  this->Integrals.release(window);
  this->Variations.release(window);
}

std::size_t TableTextures::bytes() const
{
  return this->Values.bytes() + this->Integrals.bytes() + this->Variations.bytes();
}

} // namespace tetmarch
