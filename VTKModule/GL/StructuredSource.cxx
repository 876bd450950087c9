// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/StructuredSource.h"

#include "Appearance/Blending.h"
#include "Caching/WithinMemory.h"
#include "GL/Uniforms.h"
#include "Rays/View.h"
#include "Structured/LightNodes.h"
#include "Variants/VariantKey.h"

#include "vtkDataSet.h"
#include "vtkOpenGLRenderUtilities.h" // the GL
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <limits>

namespace tetmarch
{
namespace
{

// A share of empty blocks from which on leaps are worth what asking for them costs.
constexpr double LeastShareToLeap = 0.1;

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

void bindLightNodes(vtkShaderProgram* program, const LightNodes& nodes)
{
  setInts(program, "lightNodes", nodes.Along);
  program->SetUniform3f("lightLow", nodes.Low.data());
  const std::array<double, 3> perStep{ { 1 / nodes.Step[0], 1 / nodes.Step[1],
    1 / nodes.Step[2] } };
  program->SetUniform3f("perLightStep", perStep.data());
  std::array<double, 16> matrix{};
  std::copy(nodes.ToNormalized.begin(), nodes.ToNormalized.end(), matrix.begin());
  matrix[15] = 1;
  setUniform(program, "lightNodeMatrix", matrix);
}

} // namespace

std::string StructuredSource::updateGeometry(
  vtkDataSet* data, const ResourceLimits& limits, const Progress&)
{
  const std::string error = this->Volume.updateGeometry(data);
  if (!error.empty() || this->isEmpty())
  {
    return error;
  }
  // The least that any type of value takes, before any is read.
  return describeExcess({ { "values", static_cast<std::uint64_t>(data->GetNumberOfPoints()), 1 } },
    { std::numeric_limits<std::uint64_t>::max(), limits.Bytes }, SizesAre::LowerBounds);
}

std::string StructuredSource::updateScalars(vtkDataSet* data, const DrawnScalars& drawn)
{
  if (drawn.Mix != ComponentMix::Single)
  {
    return "Several components of a structured volume can't be drawn together yet. Choose one of "
           "them by VectorMode and VectorComponent.";
  }
  return this->Volume.updateScalars(data, drawn, this->Interpolated);
}

std::string StructuredSource::updateVisibility(
  const IntegralTable& table, const Blending& blending, bool undrawnSeen)
{
  Fingerprint input = this->Volume.valuesVersion();
  add(input, versionOf(blending));
  input.push_back(undrawnSeen ? 1 : 0);
  if (blending.isComposite())
  {
    for (const std::array<float, 4>& value : table.Values)
    {
      add(input, static_cast<double>(value[3]));
    }
    add(input, table.Begin);
    add(input, table.End);
  }
  if (input == this->EmptyInput)
  {
    return {};
  }
  this->EmptyInput.clear();
  const std::string shortage = withinMemory("the distances to what is seen",
    [&]
    {
      const StageRecorder recorder(this->EmptyRecord);
      const BlockRanges& ranges = this->Volume.blockRanges();
      this->Empty = {};
      // Surfaces between constant cells lie between blocks, too, whose ranges do not tell of them.
      if (blending.isIsoSurface() && !this->Volume.lattice().Constant)
      {
        this->Empty = findBlockDistances(ranges, blending.IsoValues);
      }
      else if (blending.isComposite())
      {
        this->Empty = findBlockDistances(ranges, table, this->range(), undrawnSeen);
      }
    });
  if (shortage.empty())
  {
    this->EmptyInput = input;
  }
  return shortage;
}

bool StructuredSource::leaps() const { return this->Empty.EmptyShare >= LeastShareToLeap; }

void StructuredSource::setBits(VariantKey& key, const View&) const
{
  const Lattice& lattice = this->Volume.lattice();
  key.Structured = true;
  key.PointScalars = !lattice.Constant;
  key.Rectilinear = !lattice.isUniform();
  key.HiddenCells = !this->Volume.hiddenCells().empty();
  key.Leaps = this->leaps();
}

Fingerprint StructuredSource::version() const
{
  Fingerprint version = this->Volume.valuesVersion();
  add(version, this->Volume.hiddenVersion());
  return version;
}

std::vector<BufferSize> StructuredSource::bufferSizes() const
{
  // The texture of values is no buffer; its sizes are checked where it is made.
  return { { "hidden cells", this->Volume.hiddenCells().size(), sizeof(std::uint32_t) },
    { "blocks", this->Empty.Distances.size(), 1 } };
}

bool StructuredSource::isUploaded() const
{
  return this->ValuesThere == this->Volume.valuesVersion() &&
         this->PlanesThere == this->Volume.latticeVersion() &&
         this->HiddenThere == this->Volume.hiddenVersion() &&
         this->DistancesThere == this->EmptyInput;
}

std::string StructuredSource::uploadPlanes(vtkOpenGLRenderWindow* window)
{
  this->Planes.release(window);
  const Lattice& lattice = this->Volume.lattice();
  if (lattice.isUniform())
  {
    return {};
  }
  std::vector<float> planes;
  for (const LatticeAxis& axis : lattice.Axes)
  {
    for (int i = 0; i <= axis.Cells; ++i)
    {
      planes.push_back(static_cast<float>(axis.plane(i)));
    }
  }
  return this->Planes.upload(window, TexelFormat::R32F, planes.data(), planes.size());
}

std::string StructuredSource::upload(vtkOpenGLRenderWindow* window)
{
  std::string error;
  const auto update = [&](Uploaded& there, const Fingerprint& version, const auto& uploadAll)
  {
    if (error.empty() && there != version)
    {
      there.reset();
      const std::size_t bytes = uploadAll();
      if (error.empty())
      {
        there = version;
      }
      this->UploadedBytes += static_cast<std::int64_t>(bytes);
    }
  };
  update(this->ValuesThere, this->Volume.valuesVersion(),
    [&]
    {
      error =
        this->Values.upload(window, valuesAlong(this->Volume.lattice()), this->Volume.values()[0]);
      return this->Values.bytes();
    });
  update(this->PlanesThere, this->Volume.latticeVersion(),
    [&]
    {
      error = this->uploadPlanes(window);
      return this->Planes.bytes();
    });
  update(this->HiddenThere, this->Volume.hiddenVersion(),
    [&]
    {
      const auto& hidden = this->Volume.hiddenCells();
      this->Hidden.release(window);
      error = hidden.empty()
                ? std::string()
                : this->Hidden.upload(window, TexelFormat::R32UI, hidden.data(), hidden.size());
      return this->Hidden.bytes();
    });
  update(this->DistancesThere, this->EmptyInput,
    [&]
    {
      this->Distances.release(window);
      const auto& distances = this->Empty.Distances;
      error = !this->leaps() ? std::string()
                             : this->Distances.upload(
                                 window, TexelFormat::R8UI, distances.data(), distances.size());
      return this->Distances.bytes();
    });
  return error;
}

void StructuredSource::release(vtkWindow* window)
{
  this->Values.release(window);
  for (TextureBuffer* buffer : { &this->Planes, &this->Hidden, &this->Distances })
  {
    buffer->release(window);
  }
  for (Uploaded* there :
    { &this->ValuesThere, &this->PlanesThere, &this->HiddenThere, &this->DistancesThere })
  {
    there->reset();
  }
}

std::size_t StructuredSource::bytes() const
{
  return this->Values.bytes() + this->Planes.bytes() + this->Hidden.bytes() +
         this->Distances.bytes();
}

const char* StructuredSource::shaderOf(SourcePass pass) const
{
  switch (pass)
  {
    case SourcePass::March:
      return "passes/march.frag.glsl";
    case SourcePass::Pick:
      return "passes/pick.frag.glsl";
    case SourcePass::VertexLight:
      return "passes/vertex_light.frag.glsl";
    default: // it has no boundary faces
      return nullptr;
  }
}

std::string StructuredSource::describeBadSamples() const
{
  return describeBadDistance(this->Samples, this->frame());
}

void StructuredSource::bind(vtkShaderProgram* program, const VariantKey& key)
{
  const Lattice& lattice = this->Volume.lattice();
  const StoredValues& values = this->Volume.values().front();
  const std::array<int, 3> along = valuesAlong(lattice);
  this->Values.bind(program, "valueTexture");
  const std::array<float, 2> map{ { values.Scale, values.Offset } };
  program->SetUniform2f("valueMap", map.data());
  if (key.PointScalars)
  {
    const std::array<float, 2> texel{ { 1.0f / static_cast<float>(along[0]),
      1.0f / static_cast<float>(along[1]) } };
    program->SetUniform2f("valueTexel", texel.data());
  }
  setInts(program, "lastValue", { { along[0] - 1, along[1] - 1, along[2] - 1 } });
  setInts(program, "latticeCells", intsOf(lattice, [](const LatticeAxis& a) { return a.Cells; }));
  setInts(
    program, "firstValue", intsOf(lattice, [](const LatticeAxis& a) { return a.FirstValue; }));
  std::array<double, 16> matrix{};
  std::copy(lattice.FromNormalized.begin(), lattice.FromNormalized.end(), matrix.begin());
  matrix[15] = 1;
  setUniform(program, "latticeMatrix", matrix);
  program->SetUniformi("mostCells", mostCellsOf(lattice));
  bindLightNodes(program, lightNodesOf(lattice));
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
  if (key.PointSampled)
  {
    const double step = this->Samples.step(this->frame());
    program->SetUniformf("sampleStep", static_cast<float>(step));
    program->SetUniformf("samplesPerDepth", static_cast<float>(1 / step));
    program->SetUniform2f("sampleShift", this->Samples.shift().data());
  }
  if (key.Leaps)
  {
    this->Distances.bind(program, "blockDistanceBuffer");
    setInts(program, "blockCount", this->Empty.Blocks);
  }
  if (key.HiddenCells)
  {
    this->Hidden.bind(program, "hiddenCellBuffer");
  }
}

void StructuredSource::unbind()
{
  this->Values.unbind();
  for (TextureBuffer* buffer : { &this->Planes, &this->Hidden, &this->Distances })
  {
    buffer->unbind();
  }
}

ReferenceScene StructuredSource::withVolume(ReferenceScene scene) const
{
  scene.Cells = &this->Volume.lattice();
  scene.Values = &this->Volume.values().front();
  scene.Range = this->range();
  scene.Hidden = &this->Volume.hiddenCells();
  scene.Samples = this->Samples;
  return scene;
}

ReferenceImage StructuredSource::renderReference(
  ReferenceScene scene, const AccuracyLevel& level) const
{
  return tetmarch::renderReference<double>(this->withVolume(scene), level);
}

RayTrace StructuredSource::traceRay(ReferenceScene scene, const TraceOptions& options) const
{
  const ReferenceScene whole = this->withVolume(scene);
  return options.InDouble ? tetmarch::traceRay<double>(whole, options.Level, options.X, options.Y)
                          : tetmarch::traceRay<float>(whole, options.Level, options.X, options.Y);
}

} // namespace tetmarch
