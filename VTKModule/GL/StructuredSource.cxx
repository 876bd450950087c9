// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GL/StructuredSource.h"

#include "Appearance/Blending.h"
#include "Caching/WithinMemory.h"
#include "Rays/View.h"
#include "Variants/VariantKey.h"

#include "vtkDataSet.h"

#include <limits>

namespace tetmarch
{
namespace
{

// Of the blocks, the empty ones: what leaps gain and what asking for them costs is much the same.
constexpr double LeastShareToKeepLeaping = 0.05;

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
  return this->Volume.updateScalars(data, drawn, this->Interpolated);
}

// Of dependent components the first one is that of the opacity: the others show nothing without it.
std::vector<ShownScalar> StructuredSource::shownScalars(
  const IntegralTable& first, const Components& parts) const
{
  const std::vector<BlockRanges>& ranges = this->Volume.blockRanges();
  std::vector<ShownScalar> shown{ { &ranges.front(), &first, this->range() } };
  for (std::size_t k = 1; k < ranges.size(); ++k)
  {
    shown.push_back({ &ranges[k], &parts.Tables[k - 1], this->furtherRanges()[k - 1] });
  }
  return shown;
}

std::string StructuredSource::updateVisibility(
  const IntegralTable& first, const Components& parts, const Blending& blending, bool undrawnSeen)
{
  return withinMemory("the distances to what is seen",
    [&]
    {
      const StageRecorder recorder(this->EmptyRecord);
      const std::vector<ShownScalar> shown = this->shownScalars(first, parts);
      this->Empty = {};
      // Surfaces between constant cells lie between blocks, too, whose ranges do not tell of them.
      if (blending.isIsoSurface() && !this->Volume.lattice().Constant)
      {
        this->Empty = findBlockDistances(*shown.front().Ranges, blending.IsoValues);
      }
      else if (blending.isComposite())
      {
        this->Empty = findBlockDistances(shown, undrawnSeen);
      }
      this->Leaps.update(isWorthLeaping(this->Empty),
        this->Empty.EmptyShare >= LeastShareToKeepLeaping, this->version());
    });
}

VersionedDistances StructuredSource::distances() const
{
  return { this->Empty, this->Leaps.isOn(),
    { static_cast<std::uintptr_t>(this->EmptyRecord.Runs) } };
}

void StructuredSource::setBits(VariantKey& key, const View&) const
{
  const Lattice& lattice = this->Volume.lattice();
  key.Structured = true;
  key.PointScalars = !lattice.Constant;
  key.Rectilinear = !lattice.isUniform();
  key.HiddenCells = !this->Volume.hiddenCells().empty();
  key.Leaps = this->Leaps.isOn();
  this->Textures.setBits(key);
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

Fingerprint StructuredSource::samplesVersion() const
{
  Fingerprint version;
  add(version, this->Samples.Distance);
  return version;
}

const char* StructuredSource::shaderOf(SourcePass pass) const
{
  // Rays enter it once, and not by boundary faces.
  return pass == SourcePass::Visits || pass == SourcePass::BoundaryView ? nullptr : fileOf(pass);
}

std::string StructuredSource::describeBadSamples() const
{
  return describeBadDistance(this->Samples, this->frame());
}

void StructuredSource::bind(vtkShaderProgram* program, const VariantKey& key)
{
  this->Textures.bind(program, key, this->Volume, this->Empty, this->Samples);
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
