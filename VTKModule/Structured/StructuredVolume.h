// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The stages of an image or a rectilinear grid, each of which runs again only when its input has
// changed.
#ifndef TetMarchStructuredStructuredVolume_h
#define TetMarchStructuredStructuredVolume_h

#include "Caching/Fingerprint.h"
#include "Caching/StageRecord.h"
#include "Input/GridGeometry.h"
#include "Scalars/DrawnScalars.h"
#include "Structured/EmptySpace.h"
#include "Structured/HiddenLatticeStage.h"
#include "Structured/Lattice.h"
#include "Structured/LatticeBuilder.h"
#include "Structured/LightNodes.h"
#include "Structured/StoredValues.h"

#include <string>
#include <vector>

class vtkDataSet;

namespace tetmarch
{

class StructuredVolume
{
public:
  StructuredVolume() = default;
  StructuredVolume(const StructuredVolume&) = delete;
  StructuredVolume& operator=(const StructuredVolume&) = delete;

  /** The extent and the coordinates of the data, and the frame. Returns an empty string, or an
   * error with its remedy; the volume is then empty. The data are a vtkImageData (or
   * vtkUniformGrid) or a vtkRectilinearGrid. Other data with the same coordinates keep the lattice.
   */
  std::string updateGeometry(vtkDataSet* data);
  /**
   * The lattice for the array and the interpolation, its hidden cells, its values and their ranges.
   * Returns an empty string, or an error with its remedy; there are then no values. Each is made
   * again when its input has changed: a new array keeps the lattice, another interpolation keeps
   * the values.
   */
  std::string updateScalars(
    vtkDataSet* data, const DrawnScalars& drawn, Interpolation interpolation);

  bool isEmpty() const { return this->Geometry.isEmpty(); }
  /** Known from updateGeometry() on; the rest of the lattice from updateScalars() on. */
  const VolumeFrame& frame() const { return this->Frame; }
  const Lattice& lattice() const { return this->Made; }
  /** The nodes of the lattice. */
  const LightNodes& lightNodes() const { return this->Nodes; }
  /** The first scalar, and further ones. */
  const std::vector<StoredValues>& values() const { return this->Values; }
  const std::vector<ScalarRange>& furtherRanges() const { return this->FurtherRanges; }
  /** One bit for each cell of the lattice: bit c % 32 of word c / 32. Empty if none is hidden. See
   * hiddenLatticeCells(). */
  const std::vector<std::uint32_t>& hiddenCells() const { return this->Hidden.cells(); }
  /** Ranges of the first scalar and of further independent ones. Dependent ones are invisible where
   * the first one has no opacity. */
  const std::vector<BlockRanges>& blockRanges() const { return this->Ranges; }
  /** The cell of the data that contains a point, given in the normalised frame, of a cell of the
   * lattice, which may overlap eight of them. */
  vtkIdType dataCellOf(std::uint32_t cell, const Vector3& point) const;

  /** Equal as long as the lattice is the same; one word. */
  Fingerprint latticeVersion() const;
  /** Equal as long as the lattice and its values are the same. The first word is that of the
   * lattice. */
  Fingerprint valuesVersion() const;
  /** Equal as long as the same cells of the same lattice are hidden; empty without ghost arrays. */
  const Fingerprint& hiddenVersion() const { return this->Hidden.version(); }

  const StageRecord& latticeRecord() const { return this->LatticeRecord; }
  const StageRecord& valuesRecord() const { return this->ValuesRecord; }
  const StageRecord& rangesRecord() const { return this->RangesRecord; }
  /** Of all stages. */
  std::int64_t runs() const
  {
    return this->LatticeRecord.Runs + this->Hidden.record().Runs + this->ValuesRecord.Runs +
           this->RangesRecord.Runs;
  }

private:
  std::string updateLattice(const LatticeCase& lies);
  std::string updateHidden(vtkDataSet* data);
  std::string updateValues(const DrawnScalars& drawn);
  std::string updateRanges(ComponentMix mix);
  void clearValues();

  GridGeometry Geometry;
  VolumeFrame Frame;
  Fingerprint LatticeInput; // besides the geometry
  LatticeCase Case;
  Lattice Made;
  LightNodes Nodes;
  HiddenLatticeStage Hidden;
  Fingerprint ValuesInput;
  std::vector<StoredValues> Values;
  std::vector<ScalarRange> FurtherRanges;
  Fingerprint RangesInput;
  std::vector<BlockRanges> Ranges;
  StageRecord LatticeRecord;
  StageRecord ValuesRecord;
  StageRecord RangesRecord;
};

} // namespace tetmarch

#endif
