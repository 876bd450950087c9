// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of a grid with what is drawn of them: the stages that make it, each of which runs
// again only when its own input changed.
#ifndef TetMarchVolumeTetVolume_h
#define TetMarchVolumeTetVolume_h

#include "Entries/VisiblePart.h"
#include "Mesh/HiddenCellStage.h"
#include "Mesh/MeshScalars.h"
#include "Mesh/MeshStage.h"
#include "Volume/TetEffectSource.h"

#include <string>

namespace tetmarch
{

class TetVolume
{
public:
  TetVolume() = default;
  TetVolume(const TetVolume&) = delete;
  TetVolume& operator=(const TetVolume&) = delete;

  void setGroup(Group* group, std::uintptr_t generation)
  {
    this->Effects.setGroup(group, generation);
  }
  void setPiece(const PieceOptions& piece) { this->Piece = piece; }
  /** Of the first and of further scalars; without any, or without memory, none. */
  std::vector<FiniteRange> rangesOf(vtkUnstructuredGrid* grid, const DrawnScalars& drawn);
  /** The mesh of the grid, and which of its cells are hidden. Returns an empty string, or what is
   * wrong; the mesh is empty then, and if progress asked to stop. */
  std::string updateGeometry(
    vtkUnstructuredGrid* grid, const ResourceLimits& limits, const Progress& progress);
  /** The stored scalars. Returns an empty string, or what is wrong. */
  std::string updateScalars(vtkUnstructuredGrid* grid, const DrawnScalars& drawn);
  /** The tetrahedra of which something may be seen by the table of the opacity, or of surfaces. All
   * may be seen in other blend modes, and if there is no one table (nullptr). Returns an empty
   * string, or what is wrong. */
  std::string updateVisiblePart(
    const IntegralTable* table, const Blending& blending, bool undrawnSeen);
  /** The hierarchy of the boundary, for rays that have no list of entries. Returns an empty string,
   * or what is wrong. */
  std::string ensureHierarchy();

  const TetMesh& mesh() const { return this->Meshed.mesh(); }
  const HiddenCells& hiddenCells() const { return this->Hidden.cells(); }
  const MeshScalars& scalars() const { return this->Scalars; }
  /** Without faces if all of the mesh may be seen, or nothing. */
  const VisiblePart& visiblePart() const { return this->Visible; }
  const EffectSource& effectSource() const { return this->Effects; }

  /** Versions of what is uploaded: equal as long as it is the same. */
  Fingerprint linksVersion() const;
  /** The first word is that of the mesh. */
  const Fingerprint& scalarsVersion() const { return this->ScalarsVersion; }
  const Fingerprint& hiddenVersion() const { return this->Hidden.version(); }
  Fingerprint visibleVersion() const;

  const StageRecord& meshRecord() const { return this->Meshed.record(); }
  const StageRecord& scalarsRecord() const { return this->ScalarsRecord; }
  const StageRecord& visibleRecord() const { return this->VisibleRecord; }
  /** Of all stages. */
  std::int64_t runs() const
  {
    return this->meshRecord().Runs + this->Hidden.record().Runs + this->ScalarsRecord.Runs +
           this->VisibleRecord.Runs;
  }

private:
  PieceOptions Piece;
  MeshStage Meshed;
  HiddenCellStage Hidden;
  Fingerprint RangesInput;
  std::vector<FiniteRange> Ranges;
  Fingerprint ScalarsInput;
  MeshScalars Scalars;
  Fingerprint ScalarsVersion{ 0, 0 };
  StageRecord ScalarsRecord;
  VisiblePart Visible;
  StageRecord VisibleRecord;
  TetEffectSource Effects{ Meshed.mesh(), Scalars.OfCells, Scalars.Range, ScalarsVersion };
};

} // namespace tetmarch

#endif
