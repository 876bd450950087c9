// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// An image or a rectilinear grid with what is drawn of it: the stages that make it, each of which
// runs again only when its own input changed.
#ifndef TetMarchStructuredStructuredVolume_h
#define TetMarchStructuredStructuredVolume_h

#include "Budget/ResourceLimits.h"
#include "Caching/Fingerprint.h"
#include "Caching/StageRecord.h"
#include "Scalars/DrawnScalars.h"
#include "Structured/EmptySpace.h"
#include "Structured/Lattice.h"
#include "Structured/StoredValues.h"

#include <string>
#include <vector>

class vtkDataSet;

namespace tetmarch
{

/** How values are interpolated: that of a vtkVolumeProperty. */
enum class Interpolation : unsigned char
{
  Nearest,
  Linear
};

class StructuredVolume
{
public:
  StructuredVolume() = default;
  StructuredVolume(const StructuredVolume&) = delete;
  StructuredVolume& operator=(const StructuredVolume&) = delete;

  /** The data's extent, coordinates and hidden cells. Returns an empty string, or what is wrong and
   * what to do; takes a vtkImageData (vtkUniformGrid, too) or a vtkRectilinearGrid. */
  std::string updateGeometry(vtkDataSet* data);
  /** The lattice that the array and the interpolation call for, and its stored values. */
  std::string updateScalars(
    vtkDataSet* data, const DrawnScalars& drawn, Interpolation interpolation);

  bool isEmpty() const { return this->Empty; }
  /** Known from updateGeometry() on; the rest of the lattice from updateScalars() on. */
  const VolumeFrame& frame() const { return this->Frame; }
  const Lattice& lattice() const { return this->Made; }
  /** The first scalar, and those that are drawn with it. */
  const std::vector<StoredValues>& values() const { return this->Values; }
  const std::vector<ScalarRange>& furtherRanges() const { return this->FurtherRanges; }
  /** One bit for each cell of the lattice: bit c % 32 of word c / 32. Empty if none is hidden. */
  const std::vector<std::uint32_t>& hiddenCells() const { return this->Hidden; }
  const BlockRanges& blockRanges() const { return this->Ranges; }
  /** The cell of the data that a cell of the lattice is in, or the first one that it overlaps. */
  vtkIdType dataCellOf(std::uint32_t cell) const;

  /** Equal as long as the lattice is the same; one word. */
  Fingerprint latticeVersion() const;
  /** Equal as long as the lattice and its values are the same. The first word is that of the
   * lattice. */
  Fingerprint valuesVersion() const;
  Fingerprint hiddenVersion() const;

  const StageRecord& latticeRecord() const { return this->LatticeRecord; }
  const StageRecord& valuesRecord() const { return this->ValuesRecord; }
  const StageRecord& rangesRecord() const { return this->RangesRecord; }
  /** Of all stages. */
  std::int64_t runs() const
  {
    return this->LatticeRecord.Runs + this->ValuesRecord.Runs + this->RangesRecord.Runs;
  }

private:
  bool Empty = true;
  VolumeFrame Frame;
  Lattice Made;
  std::vector<StoredValues> Values;
  std::vector<ScalarRange> FurtherRanges;
  std::vector<std::uint32_t> Hidden;
  BlockRanges Ranges;
  StageRecord LatticeRecord;
  StageRecord ValuesRecord;
  StageRecord RangesRecord;
};

} // namespace tetmarch

#endif
