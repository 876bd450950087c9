// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of a vtkUnstructuredGrid are what rays march through.
#ifndef TetMarchGLTetSource_h
#define TetMarchGLTetSource_h

#include "Caching/Switch.h"
#include "GL/EntryListTextures.h"
#include "GL/MarchSource.h"
#include "GL/MeshTextures.h"
#include "GL/Uploaded.h"
#include "GL/VisiblePartTextures.h"
#include "Scalars/HiddenBits.h"
#include "Volume/TetVolume.h"

namespace tetmarch
{

class TetSource : public MarchSource
{
public:
  const TetMesh& mesh() const { return this->Volume.mesh(); }
  const StageRecord& meshRecord() const { return this->Volume.meshRecord(); }
  const StageRecord& scalarsRecord() const { return this->Volume.scalarsRecord(); }
  const StageRecord& visibleRecord() const { return this->Volume.visibleRecord(); }
  const StageRecord& entriesRecord() const { return this->EntriesRecord; }

  void setGroup(Group* group, std::uintptr_t generation) override
  {
    this->Volume.setGroup(group, generation);
  }
  void setPiece(const PieceOptions& piece) override { this->Volume.setPiece(piece); }
  std::vector<FiniteRange> rangesOf(vtkDataSet* data, const DrawnScalars& drawn) override;
  std::string updateGeometry(
    vtkDataSet* data, const ResourceLimits& limits, const Progress& progress) override;
  std::string updateScalars(vtkDataSet* data, const DrawnScalars& drawn) override;
  std::string updateVisibility(const IntegralTable& first, const Components& parts,
    const Blending& blending, bool undrawnSeen) override;
  std::string prepareEntrySearch() override { return this->Volume.ensureHierarchy(); }

  bool isEmpty() const override { return this->mesh().Tets.empty(); }
  bool isHidden() const override
  {
    return areAllHidden(this->Volume.hiddenCells(), this->mesh().Tets.size());
  }
  bool showsNothing() const override { return tetmarch::showsNothing(this->Volume.visiblePart()); }
  const VolumeFrame& frame() const override { return this->mesh().Frame; }
  const ScalarRange& range() const override { return this->Volume.scalars().Range; }
  const std::vector<ScalarRange>& furtherRanges() const override
  {
    return this->Volume.scalars().Further.Ranges;
  }
  double transparentShare(const IntegralTable& table) const override;
  const EffectSource& effectSource() const override { return this->Volume.effectSource(); }
  vtkIdType cellOf(std::uint32_t tet, const Vector3&) const override
  {
    return this->mesh().TetCells[tet];
  }
  void setBits(VariantKey& key, const View& camera) const override;
  Fingerprint version() const override;

  std::int64_t runs() const override { return this->Volume.runs(); }

  std::vector<BufferSize> bufferSizes() const override;
  bool isUploaded() const override;
  std::string upload(vtkOpenGLRenderWindow* window) override;
  void release(vtkWindow* window) override;
  std::size_t bytes() const override
  {
    return this->Textures.bytes() + this->Visible.bytes() + this->Entries.bytes();
  }
  std::int64_t uploadedBytes() const override
  {
    return this->Links.allBytes() + this->Scalars.allBytes() + this->HiddenCells.allBytes() +
           this->VisibleTets.allBytes();
  }

  std::string describeBadSamples() const override;
  void bind(vtkShaderProgram* program, const VariantKey& key) override;
  void unbind() override;

  bool mayReenter() const override { return this->mesh().NeedsHierarchy; }
  std::string listEntries(vtkOpenGLRenderWindow* window, const VariantKey& key,
    const Viewport& viewport, const View& camera) override;
  void releaseEntries(vtkWindow* window) override { this->Entries.release(window); }

  ReferenceImage renderReference(ReferenceScene scene, const AccuracyLevel& level) const override;
  RayTrace traceRay(ReferenceScene scene, const TraceOptions& options) const override;

private:
  ReferenceScene withVolume(ReferenceScene scene) const;
  /** Rays enter the visible part alone. Else, also if its faces are too many for a buffer, they
   * march through the mesh. */
  bool entersVisiblePart() const;

  TetVolume Volume;
  ResourceLimits Limits;
  MeshTextures Textures;
  Uploaded Links;
  Uploaded Scalars;
  Uploaded HiddenCells;
  Uploaded VisibleTets;
  VisiblePartTextures Visible;
  EntryListTextures Entries;
  StageRecord EntriesRecord;
  Switch EntersVisible; // if its faces are not too many
};

} // namespace tetmarch

#endif
