// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/ValueTextures.h"

#include "vtkOpenGLRenderUtilities.h" // the GL
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

constexpr int FewTextures = 2; // of a key with slabs, but not many
constexpr int OtherTextures =
  12; // that a shader may read beside the values: tables, planes, light...

// Where a driver has few texture units for a shader, many slabs could leave none for others.
int mostSlabs(int mostTextures)
{
  int units = 0;
  glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
  return units >= mostTextures + OtherTextures ? mostTextures : FewTextures;
}

std::string text(const std::array<int, 3>& sizes)
{
  return std::to_string(sizes[0]) + " x " + std::to_string(sizes[1]) + " x " +
         std::to_string(sizes[2]);
}

std::size_t bytesOf(const std::array<int, 3>& sizes, const StoredValues& values)
{
  return StoredValues::sizeOf(values.Type) * static_cast<std::size_t>(sizes[0]) *
         static_cast<std::size_t>(sizes[1]) * static_cast<std::size_t>(sizes[2]);
}

constexpr const char* Advice =
  " Close what else uses it, or extract or coarsen a part of the volume.";

} // namespace

ValueTextures::Slabs ValueTextures::slabsFor(
  const std::array<int, 3>& sizes, const std::vector<StoredValues>& values)
{
  Slabs slabs;
  slabs.Scalars = static_cast<int>(values.size());
  slabs.Layers = sizes[2];
  for (const StoredValues& scalar : values)
  {
    slabs.Layers = std::min(slabs.Layers, layersTaken(sizes, scalar.Type));
  }
  slabs.PerScalar = slabs.Layers > 0 ? (sizes[2] + slabs.Layers - 1) / slabs.Layers : 0;
  return slabs;
}

std::string ValueTextures::describeExcess(const std::array<int, 3>& sizes, const Slabs& slabs)
{
  std::array<int, 3> most = mostLayers();
  const bool tooWide = sizes[0] > most[0] || sizes[1] > most[1];
  const int textures = std::max(1, mostSlabs(MostTextures) / slabs.Scalars);
  if (!tooWide && slabs.Layers > 0 && slabs.PerScalar <= textures)
  {
    return {};
  }
  if (!tooWide)
  {
    most = { { sizes[0], sizes[1], slabs.Layers } };
  }
  most[2] *= textures;
  const bool several = slabs.Scalars > 1;
  return "The volume has " + text(sizes) + " values" +
         (several ? " of " + std::to_string(slabs.Scalars) + " components" : "") +
         ", but the GPU takes " + text(most) + " at most, in " + std::to_string(textures) +
         (textures > 1 ? " textures" : " texture") + (several ? " a component" : "") +
         ". Extract a part of it, or coarsen it" + (several ? ", or draw fewer components." : ".");
}

std::string ValueTextures::upload(vtkOpenGLRenderWindow* window, const std::array<int, 3>& sizes,
  const std::vector<StoredValues>& values)
{
  this->release(window);
  const Slabs slabs = slabsFor(sizes, values);
  const std::string excess = describeExcess(sizes, slabs);
  if (!excess.empty())
  {
    return excess;
  }
  std::size_t texture = 0;
  for (const StoredValues& scalar : values)
  {
    const auto* bytes = static_cast<const unsigned char*>(scalar.Data);
    for (int first = 0; first < sizes[2]; first += slabs.Layers)
    {
      const std::array<int, 3> slab{ { sizes[0], sizes[1],
        std::min(slabs.Layers, sizes[2] - first) } };
      if (!this->Textures[texture].upload(window, slab, scalar.Type, bytes))
      {
        this->release(window);
        const int textures = slabs.PerScalar * slabs.Scalars;
        return "The GPU has no room for a texture of " + std::to_string(bytesOf(slab, scalar)) +
               " bytes" +
               (textures > 1 ? ", which is number " + std::to_string(texture + 1) + " of " +
                                 std::to_string(textures) + " that the values need"
                             : "") +
               "." + Advice;
      }
      ++texture;
      bytes += bytesOf(slab, scalar);
    }
  }
  this->There = slabs;
  return {};
}

void ValueTextures::setBits(VariantKey& key) const
{
  key.Slabs = this->There.PerScalar > 1;
  key.ManySlabs = key.Slabs && this->There.PerScalar * this->There.Scalars > FewTextures;
}

void ValueTextures::bind(vtkShaderProgram* program, std::size_t scalar, const char* sampler)
{
  this->Textures[scalar].bind(program, sampler);
}

void ValueTextures::bindSlabs(vtkShaderProgram* program, const VariantKey& key)
{
  // Samplers without a texture of their own are never read; they get the last one.
  const int there = this->There.PerScalar * this->There.Scalars;
  const int samplers = key.ManySlabs ? MostTextures : FewTextures;
  std::array<int, MostTextures> units{};
  for (int t = 0; t < samplers; ++t)
  {
    units[t] = this->Textures[std::min(t, there - 1)].activate();
  }
  const auto location = [program](const char* name)
  { return glGetUniformLocation(program->GetHandle(), name); };
  glUniform1iv(location("slabTextures"), samplers, units.data());
  program->SetUniformi("slabLayers", this->There.Layers);
  if (key.hasComponents())
  {
    std::array<int, MostComponents - 1> first{};
    for (int k = 0; k < MostComponents - 1; ++k)
    {
      const int drawn = std::min(k + 1, this->There.Scalars - 1);
      first[k] = this->There.Layers * this->There.PerScalar * drawn;
    }
    glUniform1iv(location("extraLayers"), MostComponents - 1, first.data());
  }
}

void ValueTextures::unbind()
{
  for (ArrayTexture& texture : this->Textures)
  {
    texture.unbind();
  }
}

void ValueTextures::release(vtkWindow* window)
{
  for (ArrayTexture& texture : this->Textures)
  {
    texture.release(window);
  }
  this->There = {};
}

std::size_t ValueTextures::bytes() const
{
  std::size_t bytes = 0;
  for (const ArrayTexture& texture : this->Textures)
  {
    bytes += texture.bytes();
  }
  return bytes;
}

} // namespace tetmarch
