// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of an unstructured or curvilinear grid, their scalars and what is visible. A stage
// makes each of these. It runs again when its input has changed.
#ifndef TetMarchVolumeTetVolume_h
#define TetMarchVolumeTetVolume_h

#include "Caching/Switch.h"
#include "Entries/EyeStart.h"
#include "Entries/VisiblePartFinder.h"
#include "Mesh/HiddenCellStage.h"
#include "Mesh/MeshScalars.h"
#include "Mesh/MeshStage.h"
#include "Scalars/HiddenBits.h"
#include "Volume/MarchedVolume.h"

namespace tetmarch
{

class TetVolume : public MarchedVolume
{
public:
  TetVolume() = default;
  TetVolume(const TetVolume&) = delete;
  TetVolume& operator=(const TetVolume&) = delete;

  /** The mesh of the grid, and which of its cells are hidden. The mesh is empty if something is
   * wrong, and if progress asked to stop. */
  std::string updateGeometry(
    const VolumeInput& input, const ResourceLimits& limits, const Progress& progress) override;
  std::string updateScalars(const VolumeInput& input, const DrawnScalars& drawn) override;
  /** The tetrahedra of which something may be seen by the table of the opacity, or of surfaces. All
   * may be seen in other blend modes, and if several tables show something. */
  std::string updateVisibility(const IntegralTable& first, const Components& parts,
    const Blending& blending, bool undrawnSeen) override;
  /** The hierarchy of the boundary. */
  std::string prepareEntrySearch() override;
  std::string updateEye(const Vector3* eye) override;
  /** The ranges of the scalars that would be drawn, the first and extra ones; without any, or
   * without memory, none. */
  std::vector<FiniteRange> rangesOf(vtkDataSet* grid, const DrawnScalars& drawn);

  bool isEmpty() const override { return this->mesh().Tets.empty(); }
  bool isHidden() const override
  {
    return areAllHidden(this->hiddenCells(), this->mesh().Tets.size());
  }
  bool showsNothing() const override { return tetmarch::showsNothing(this->visiblePart()); }
  bool isStructured() const override { return false; }
  bool startsAtEye() const override;
  bool mayReenter() const override { return this->mesh().MayReenter; }
  const std::vector<ScalarRange>& extraRanges() const override
  {
    return this->Scalars.Extra.Ranges;
  }
  double transparentShare(const IntegralTable& table) const override;
  vtkIdType cellOf(std::uint32_t tet, const Vector3&) const override
  {
    return this->mesh().TetCells[tet];
  }
  double leastDetail() const override { return 0; }
  std::vector<OutlineEdge> outlineEdges() const override { return outlineEdgesOf(this->mesh()); }
  void setBits(VariantKey& key) const override;
  Fingerprint version() const override;
  std::int64_t runs() const override
  {
    return this->meshRecord().Runs + this->Hidden.record().Runs + this->ScalarsRecord.Runs +
           this->VisibleRecord.Runs;
  }
  void addTo(ReferenceScene& scene) const override;

  // As the effects of light and gradients see it.
  const VolumeFrame& frame() const override { return this->mesh().Frame; }
  const ScalarRange& range() const override { return this->Scalars.Range; }
  Fingerprint geometryVersion() const override;
  /** The first word is that of the mesh. */
  Fingerprint scalarsVersion() const override { return this->ScalarsVersion; }
  Fingerprint startsVersion() const override;
  bool hasCellGradients() const override { return this->Scalars.OfCells.empty(); }
  bool needsCellGradients() const override { return !this->Scalars.OfCorners.empty(); }
  std::vector<std::array<float, 3>> gradients(bool ofCells, Group* processes) const override;
  std::vector<std::array<float, 3>> componentGradients(Group* processes) const override;
  std::vector<VertexStart> vertexStarts() const override;
  bool startPoint(std::size_t vertex, const VertexStart& start, Vector3& point) const override;

  const TetMesh& mesh() const { return this->Meshed.mesh(); }
  const HiddenCells& hiddenCells() const { return this->Hidden.cells(); }
  const MeshScalars& scalars() const { return this->Scalars; }
  /** Without faces if all of the mesh may be seen, or nothing. */
  const VisiblePart& visiblePart() const { return this->Visible.part(); }
  /** Rays enter the visible part alone. Else, also if its faces are too many for a buffer, they
   * march through the mesh. */
  bool entersVisiblePart() const;
  /** Rays enter a part by its own faces: the visible one or, from an eye in the mesh, all of it. */
  bool entersPart() const { return this->entersVisiblePart() || this->startsAtEye(); }
  const VisiblePart& enteredPart() const
  {
    return this->entersVisiblePart() ? this->visiblePart() : this->EyeStarts.whole();
  }
  const EyeStart& eyeStart() const { return this->EyeStarts.start(); }
  const ResourceLimits& limits() const { return this->Limits; }

  // Versions of what is uploaded: equal as long as it is the same.
  Fingerprint linksVersion() const;
  const Fingerprint& hiddenVersion() const { return this->Hidden.version(); }
  Fingerprint visibleVersion() const;
  Fingerprint enteredVersion() const;

  const StageRecord& meshRecord() const { return this->Meshed.record(); }
  const StageRecord& scalarsRecord() const { return this->ScalarsRecord; }
  const StageRecord& visibleRecord() const { return this->VisibleRecord; }

private:
  std::string readScalars(const VolumeInput& input, const DrawnScalars& drawn);
  std::string prepareAgain(const VolumeInput& input, const DrawnScalars& drawn);

  ResourceLimits Limits;
  MeshStage Meshed;
  bool SeparatePoints = false;
  Fingerprint SidesApart; // the scalars that jump where sides of a curvilinear grid meet
  HiddenCellStage Hidden;
  Fingerprint RangesInput;
  std::vector<FiniteRange> Ranges;
  Fingerprint ScalarsInput;
  MeshScalars Scalars;
  Fingerprint ScalarsVersion{ 0, 0 };
  StageRecord ScalarsRecord;
  VisiblePartFinder Visible;
  StageRecord VisibleRecord;
  Switch EntersVisible; // if its faces are not too many
  EyeStartFinder EyeStarts;
};

} // namespace tetmarch

#endif
