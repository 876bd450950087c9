// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/TableTextures.h"

#include "Frame/FrameStages.h"
#include "GL/MarchPass.h"
#include "GL/Uniforms.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <vector>

namespace tetmarch
{

namespace
{

void bindSeveral(vtkShaderProgram* program, const std::vector<TablePlace>& tables)
{
  std::vector<int> first, sizes;
  std::vector<float> units, places;
  for (const TablePlace& place : tables)
  {
    first.push_back(place.First);
    sizes.push_back(place.Size);
    for (const double unit : place.IntegralUnit)
    {
      units.push_back(static_cast<float>(unit));
    }
    places.push_back(static_cast<float>(place.Scale));
    places.push_back(static_cast<float>(place.Offset));
  }
  const int count = static_cast<int>(tables.size());
  program->SetUniform1iv("tableFirst", count, first.data());
  program->SetUniform1iv("tableSizes", count, sizes.data());
  program->SetUniform4fv("tableIntegralUnits", count, units.data());
  program->SetUniform2fv("tablePlace", count, places.data());
}

using VariationTexels = std::vector<std::array<float, 4>>;

// Of colour, extinction and the two slopes; 0 for slopes that were not asked for.
void appendVariations(const IntegralTable& table, VariationTexels& variations)
{
  for (std::size_t i = 0; i < table.Values.size(); ++i)
  {
    const std::array<float, 2> slopes =
      table.SlopeVariations.empty() ? std::array<float, 2>{} : table.SlopeVariations[i];
    variations.push_back(
      { { table.Variations[i], table.ExtinctionVariations[i], slopes[0], slopes[1] } });
  }
}

std::string uploadVariations(vtkOpenGLRenderWindow* window, const VariationTexels& variations,
  bool withSlopes, TextureBuffer& buffer)
{
  if (withSlopes)
  {
    return buffer.upload(window, TexelFormat::RGBA32F, variations.data(), variations.size());
  }
  std::vector<std::array<float, 2>> without;
  for (const std::array<float, 4>& texel : variations)
  {
    without.push_back({ { texel[0], texel[1] } });
  }
  return buffer.upload(window, TexelFormat::RG32F, without.data(), without.size());
}

void bindFactors(vtkShaderProgram* program, const Components& components)
{
  program->SetUniformi("componentCount", components.count());
  setUniform(program, "componentFactor", components.Factors);
}

} // namespace

std::string TableTextures::uploadSeveral(
  vtkOpenGLRenderWindow* window, const IntegralTable& table, const Components& components)
{
  std::vector<std::array<float, 4>> values;
  std::vector<std::array<std::uint32_t, 4>> integrals;
  VariationTexels variations;
  const auto append = [&](const IntegralTable& one)
  {
    values.insert(values.end(), one.Values.begin(), one.Values.end());
    integrals.insert(integrals.end(), one.Integrals.begin(), one.Integrals.end());
    appendVariations(one, variations);
  };
  append(table);
  std::for_each(components.Tables.begin(), components.Tables.end(), append);
  const std::size_t size = values.size();
  std::string error = this->Values.upload(window, TexelFormat::RGBA32F, values.data(), size);
  if (error.empty())
  {
    error = this->Integrals.upload(window, TexelFormat::RGBA32UI, integrals.data(), size);
  }
  return error.empty()
           ? uploadVariations(window, variations, !table.SlopeVariations.empty(), this->Variations)
           : error;
}

std::string TableTextures::uploadFirst(vtkOpenGLRenderWindow* window, const IntegralTable& table)
{
  const std::size_t size = table.Values.size();
  std::string error = this->Values.upload(window, TexelFormat::RGBA32F, table.Values.data(), size);
  if (error.empty())
  {
    error = this->Integrals.upload(window, TexelFormat::RGBA32UI, table.Integrals.data(), size);
  }
  if (!error.empty())
  {
    return error;
  }
  if (table.ExtinctionVariations.empty())
  {
    return this->Variations.upload(window, TexelFormat::R32F, table.Variations.data(), size);
  }
  VariationTexels variations;
  appendVariations(table, variations);
  return uploadVariations(window, variations, !table.SlopeVariations.empty(), this->Variations);
}

std::string TableTextures::upload(vtkOpenGLRenderWindow* window, const TransferTables& tables)
{
  const Components& components = tables.components();
  return this->There.update(
    versionOf(tables),
    [&]
    {
      return components.isSingle() ? this->uploadFirst(window, tables.first())
                                   : this->uploadSeveral(window, tables.first(), components);
    },
    [&] { return this->bytes(); });
}

void TableTextures::bind(vtkShaderProgram* program, const MarchInputs& inputs)
{
  const VariantKey& key = inputs.Key;
  const IntegralTable& table = inputs.Stages->tables().first();
  const Components& components = inputs.Stages->tables().components();
  const ScalarRange& range = inputs.Stages->volume().range();
  if (key.accumulatesOpacity())
  {
    program->SetUniformf("givenTolerance", static_cast<float>(inputs.Level.ErrorTolerance));
  }
  if (!key.usesTables())
  {
    return;
  }
  this->Values.bind(program, "tableValueBuffer");
  if (key.hasComponents())
  {
    bindSeveral(program, components.places(table, range));
  }
  else
  {
    program->SetUniformi("tableSize", table.size());
  }
  if (!key.hasOpacityTable())
  {
    bindFactors(program, components);
  }
  else
  {
    program->SetUniformf("tableScale", static_cast<float>(table.scale(range.width())));
    program->SetUniformf("tableOffset", static_cast<float>(table.offset(range.Low)));
  }
  if (key.TransparentRanges)
  {
    program->SetUniform4f("givenTransparentRanges", table.Traits.Transparent.data());
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
  }
  if (key.PointScalars && !key.hasComponents())
  {
    setUniform(program, "givenIntegralUnit", table.IntegralUnit);
  }
  if (key.needsVariations())
  {
    this->Variations.bind(program, "tableVariationBuffer");
  }
  if (key.Adaptive)
  {
    program->SetUniformi("givenTrials", inputs.Level.MostTrials);
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
  this->There.forget();
}

std::size_t TableTextures::bytes() const
{
  return this->Values.bytes() + this->Integrals.bytes() + this->Variations.bytes();
}

} // namespace tetmarch
