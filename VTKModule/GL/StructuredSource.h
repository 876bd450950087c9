// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of an image or a rectilinear grid are what rays march through.
#ifndef TetMarchGLStructuredSource_h
#define TetMarchGLStructuredSource_h

#include "Caching/Switch.h"
#include "GL/LatticeTextures.h"
#include "GL/MarchSource.h"
#include "Rays/RaySamples.h"
#include "Scalars/HiddenBits.h"
#include "Structured/EmptySpace.h"
#include "Structured/StructuredVolume.h"
#include "Volume/StructuredEffectSource.h"

namespace tetmarch
{

class StructuredSource : public MarchSource
{
public:
  /** How values are interpolated; before updateScalars(). */
  void setInterpolation(Interpolation interpolation) { this->Interpolated = interpolation; }
  /** Where rays sample the volume at a level that does. */
  void setSamples(const RaySamples& samples) { this->Samples = samples; }

  const StructuredVolume& volume() const { return this->Volume; }
  const BlockDistances& emptySpace() const { return this->Empty; }
  const StageRecord& emptySpaceRecord() const { return this->EmptyRecord; }

  std::string updateGeometry(
    vtkDataSet* data, const ResourceLimits& limits, const Progress& progress) override;
  std::string updateScalars(vtkDataSet* data, const DrawnScalars& drawn) override;
  std::string prepareEntrySearch() override { return {}; }
  std::string updateVisibility(const IntegralTable& first, const Components& parts,
    const Blending& blending, bool undrawnSeen) override;

  bool isEmpty() const override { return this->Volume.isEmpty(); }
  bool isHidden() const override
  {
    return areAllHidden(this->Volume.hiddenCells(), this->Volume.lattice().numberOfCells());
  }
  bool showsNothing() const override { return this->Empty.EmptyShare == 1; }
  const VolumeFrame& frame() const override { return this->Volume.frame(); }
  const ScalarRange& range() const override { return this->Volume.values().front().Range; }
  const std::vector<ScalarRange>& furtherRanges() const override
  {
    return this->Volume.furtherRanges();
  }
  bool scalarBends() const override { return true; }
  /** Cells of which nothing is seen are leapt over or passed, if there are blocks of them. */
  double transparentShare(const IntegralTable&) const override { return this->Empty.EmptyShare; }
  const EffectSource& effectSource() const override { return this->Effects; }
  vtkIdType cellOf(std::uint32_t cell, const Vector3& point) const override
  {
    return this->Volume.dataCellOf(cell, point);
  }
  void setBits(VariantKey& key, const View& camera) const override;
  Fingerprint version() const override;
  std::int64_t runs() const override { return this->Volume.runs() + this->EmptyRecord.Runs; }

  std::vector<BufferSize> bufferSizes() const override;
  bool isUploaded() const override
  {
    return this->Textures.isCurrent(this->Volume, this->distances());
  }
  std::string upload(vtkOpenGLRenderWindow* window) override
  {
    return this->Textures.upload(window, this->Volume, this->distances());
  }
  void release(vtkWindow* window) override { this->Textures.release(window); }
  std::size_t bytes() const override { return this->Textures.bytes(); }
  std::int64_t uploadedBytes() const override { return this->Textures.uploadedBytes(); }

  const char* shaderOf(SourcePass pass) const override;
  std::string describeBadSamples() const override;
  Fingerprint samplesVersion() const override;
  void bind(vtkShaderProgram* program, const VariantKey& key) override;
  void unbind() override { this->Textures.unbind(); }

  bool mayReenter() const override { return false; }
  /** Rays enter a lattice by the planes of its sides, so that nothing is listed. */
  std::string listEntries(
    vtkOpenGLRenderWindow*, const VariantKey&, const Viewport&, const View&) override
  {
    return {};
  }
  void releaseEntries(vtkWindow*) override {}

  ReferenceImage renderReference(ReferenceScene scene, const AccuracyLevel& level) const override;
  RayTrace traceRay(ReferenceScene scene, const TraceOptions& options) const override;

private:
  std::vector<ShownScalar> shownScalars(const IntegralTable& first, const Components& parts) const;
  ReferenceScene withVolume(ReferenceScene scene) const;
  VersionedDistances distances() const;

  Interpolation Interpolated = Interpolation::Linear;
  RaySamples Samples;
  StructuredVolume Volume;
  StructuredEffectSource Effects{ Volume };
  BlockDistances Empty;
  StageRecord EmptyRecord;
  Switch Leaps;
  LatticeTextures Textures;
};

} // namespace tetmarch

#endif
