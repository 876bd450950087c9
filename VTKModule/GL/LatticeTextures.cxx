// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/LatticeTextures.h"

#include "GL/Uniforms.h"
#include "Structured/MostSteps.h"
#include "Volume/StructuredVolume.h"

#include "vtkOpenGLRenderUtilities.h" // the GL
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <vector>

namespace tetmarch
{
namespace
{

template <typename Of>
std::array<int, 3> intsOf(const Lattice& lattice, const Of& of)
{
  return { { of(lattice.Axes[0]), of(lattice.Axes[1]), of(lattice.Axes[2]) } };
}

template <typename Of>
std::array<float, 3> floatsOf(const Lattice& lattice, const Of& of)
{
  return { { static_cast<float>(of(lattice.Axes[0])), static_cast<float>(of(lattice.Axes[1])),
    static_cast<float>(of(lattice.Axes[2])) } };
}

std::array<int, 3> valuesAlong(const Lattice& lattice)
{
  return intsOf(lattice, [](const LatticeAxis& axis) { return axis.Values; });
}

// A vtkShaderProgram sets no vector of integers.
void setInts(vtkShaderProgram* program, const char* name, const std::array<int, 3>& values)
{
  const int location = glGetUniformLocation(program->GetHandle(), name);
  if (location >= 0)
  {
    glUniform3i(location, values[0], values[1], values[2]);
  }
}

// Of three rows; the fourth one is that of an affine map.
void setAffine(vtkShaderProgram* program, const char* name, const std::array<double, 12>& rows)
{
  std::array<double, 16> matrix{};
  std::copy(rows.begin(), rows.end(), matrix.begin());
  matrix[15] = 1;
  setUniform(program, name, matrix);
}

// Those of i, of j, of k.
std::vector<float> planesOf(const Lattice& lattice)
{
  std::vector<float> planes;
  for (const LatticeAxis& axis : lattice.Axes)
  {
    for (int i = 0; i <= axis.Cells; ++i)
    {
      planes.push_back(static_cast<float>(axis.plane(i)));
    }
  }
  return planes;
}

void bindLightNodes(vtkShaderProgram* program, const LightNodes& nodes)
{
  setInts(program, "lightNodes", nodes.Along);
  program->SetUniform3f("lightLow", nodes.Low.data());
  const std::array<double, 3> perStep{ { 1 / nodes.Step[0], 1 / nodes.Step[1],
    1 / nodes.Step[2] } };
  program->SetUniform3f("perLightStep", perStep.data());
  setAffine(program, "lightNodeMatrix", nodes.ToNormalized);
}

} // namespace

std::vector<BufferSize> LatticeTextures::bufferSizes() const
{
  const Octree* tree = this->Volume.octree();
  return { { "nodes of the octree", tree ? tree->Nodes.size() : 0, sizeof(std::uint32_t) },
    { "hidden cells", this->Volume.hiddenCells().size(), sizeof(std::uint32_t) },
    { "blocks", this->Volume.emptySpace().Distances.size(), 1 } };
}

bool LatticeTextures::isCurrent() const
{
  const StructuredVolume& volume = this->Volume;
  return this->ValuesThere.holds(volume.scalarsVersion()) &&
         this->Planes.isCurrent(!volume.lattice().isUniform(), volume.geometryVersion()) &&
         this->Nodes.isCurrent(volume.octree() != nullptr, volume.geometryVersion()) &&
         this->Hidden.isCurrent(!volume.hiddenCells().empty(), volume.hiddenVersion()) &&
         this->Distances.isCurrent(volume.leaps(), volume.emptySpaceVersion());
}

std::string LatticeTextures::upload(vtkOpenGLRenderWindow* window)
{
  const StructuredVolume& volume = this->Volume;
  std::string error = this->ValuesThere.update(
    volume.scalarsVersion(),
    [&] { return this->Values.upload(window, valuesAlong(volume.lattice()), volume.values()); },
    [&] { return this->Values.bytes(); });
  const auto update =
    [&](VersionedBuffer& there, bool needed, const Fingerprint& version, const auto& upload)
  { error = error.empty() ? there.update(window, needed, version, upload) : error; };
  update(this->Planes, !volume.lattice().isUniform(), volume.geometryVersion(),
    [&](TextureBuffer& buffer)
    {
      const std::vector<float> planes = planesOf(volume.lattice());
      return buffer.upload(window, TexelFormat::R32F, planes.data(), planes.size());
    });
  update(this->Nodes, volume.octree() != nullptr, volume.geometryVersion(),
    [&](TextureBuffer& buffer)
    {
      const std::vector<std::uint32_t>& nodes = volume.octree()->Nodes;
      return buffer.upload(window, TexelFormat::R32UI, nodes.data(), nodes.size());
    });
  const std::vector<std::uint32_t>& hidden = volume.hiddenCells();
  update(this->Hidden, !hidden.empty(), volume.hiddenVersion(),
    [&](TextureBuffer& buffer)
    { return buffer.upload(window, TexelFormat::R32UI, hidden.data(), hidden.size()); });
  const std::vector<std::uint8_t>& blocks = volume.emptySpace().Distances;
  update(this->Distances, volume.leaps(), volume.emptySpaceVersion(),
    [&](TextureBuffer& buffer)
    { return buffer.upload(window, TexelFormat::R8UI, blocks.data(), blocks.size()); });
  return error;
}

// A sampler of a scalar that is not drawn, which is never read, has the values of another one.
void LatticeTextures::bindExtra(vtkShaderProgram* program, const VariantKey& key)
{
  const std::vector<StoredValues>& values = this->Volume.values();
  const std::array<const char*, MostComponents - 1> samplers{ { "extraTextureA", "extraTextureB",
    "extraTextureC" } };
  const std::size_t count = key.Components == ComponentGroup::ColorAndOpacity ? 1 : samplers.size();
  std::array<std::array<float, 2>, MostComponents - 1> maps{};
  for (std::size_t k = 0; k < count; ++k)
  {
    const std::size_t drawn = std::min(k + 1, values.size() - 1);
    if (!key.Slabs)
    {
      this->Values.bind(program, drawn, samplers[k]);
    }
    maps[k] = { { values[drawn].Scale, values[drawn].Offset } };
  }
  program->SetUniform2fv("extraMap", MostComponents - 1, maps.front().data());
}

void LatticeTextures::bindValues(vtkShaderProgram* program, const VariantKey& key)
{
  const Lattice& lattice = this->Volume.lattice();
  const StoredValues& values = this->Volume.values().front();
  const std::array<int, 3> along = valuesAlong(lattice);
  if (key.Slabs)
  {
    this->Values.bindSlabs(program, key);
  }
  else
  {
    this->Values.bind(program, 0, "valueTexture");
  }
  const std::array<float, 2> map{ { values.Scale, values.Offset } };
  program->SetUniform2f("valueMap", map.data());
  if (key.hasComponents())
  {
    this->bindExtra(program, key);
  }
  if (key.PointScalars)
  {
    const std::array<float, 2> texel{ { 1.0f / static_cast<float>(along[0]),
      1.0f / static_cast<float>(along[1]) } };
    program->SetUniform2f("valueTexel", texel.data());
  }
  setInts(program, "lastValue", { { along[0] - 1, along[1] - 1, along[2] - 1 } });
  setInts(
    program, "firstValue", intsOf(lattice, [](const LatticeAxis& a) { return a.FirstValue; }));
}

void LatticeTextures::bindPlanes(vtkShaderProgram* program, const VariantKey& key)
{
  const Lattice& lattice = this->Volume.lattice();
  if (key.Rectilinear)
  {
    this->Planes.bind(program, "planeBuffer");
    const int ofI = lattice.Axes[0].Cells + 1;
    setInts(program, "firstPlane", { { 0, ofI, ofI + lattice.Axes[1].Cells + 1 } });
  }
  else
  {
    program->SetUniform3f(
      "latticeShift", floatsOf(lattice, [](const LatticeAxis& a) { return a.Shift; }).data());
    program->SetUniform3f("latticeHalfLength",
      floatsOf(lattice, [](const LatticeAxis& a) { return a.HalfLength; }).data());
  }
}

void LatticeTextures::bind(vtkShaderProgram* program, const VariantKey& key)
{
  const Lattice& lattice = this->Volume.lattice();
  this->bindValues(program, key);
  this->bindPlanes(program, key);
  setInts(program, "latticeCells", intsOf(lattice, [](const LatticeAxis& a) { return a.Cells; }));
  setAffine(program, "latticeMatrix", lattice.FromNormalized);
  program->SetUniformi("mostSteps", mostStepsOf(lattice));
  bindLightNodes(program, this->Volume.lightNodes());
  if (key.Octree)
  {
    this->Nodes.bind(program, "octreeBuffer");
    program->SetUniformi("octreeShift", this->Volume.octree()->Shift);
    setInts(program, "octreeSize", this->Volume.octree()->Size);
  }
  if (key.Leaps)
  {
    this->Distances.bind(program, "blockDistanceBuffer");
    setInts(program, "blockCount", this->Volume.emptySpace().Blocks);
  }
  if (key.HiddenCells)
  {
    this->Hidden.bind(program, "hiddenCellBuffer");
  }
}

void LatticeTextures::unbind()
{
  this->Values.unbind();
  for (VersionedBuffer* buffer : { &this->Planes, &this->Nodes, &this->Hidden, &this->Distances })
  {
    buffer->unbind();
  }
}

void LatticeTextures::release(vtkWindow* window)
{
  this->Values.release(window);
  this->ValuesThere.forget();
  for (VersionedBuffer* buffer : { &this->Planes, &this->Nodes, &this->Hidden, &this->Distances })
  {
    buffer->release(window);
  }
}

std::size_t LatticeTextures::bytes() const
{
  return this->Values.bytes() + this->Planes.bytes() + this->Nodes.bytes() + this->Hidden.bytes() +
         this->Distances.bytes();
}

std::int64_t LatticeTextures::uploadedBytes() const
{
  return this->ValuesThere.allBytes() + this->Planes.uploadedBytes() + this->Nodes.uploadedBytes() +
         this->Hidden.uploadedBytes() + this->Distances.uploadedBytes();
}

} // namespace tetmarch
