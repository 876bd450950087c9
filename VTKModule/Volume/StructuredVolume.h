// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// An image, a rectilinear grid or the leaves of an octree, and what is drawn of it. Stages make it;
// a stage runs again if its input has changed.
#ifndef TetMarchVolumeStructuredVolume_h
#define TetMarchVolumeStructuredVolume_h

#include "Caching/StageRecord.h"
#include "Caching/Switch.h"
#include "Input/GridGeometry.h"
#include "Leaves/LeafGrid.h"
#include "Scalars/HiddenBits.h"
#include "Structured/EmptySpaceStage.h"
#include "Structured/HiddenLatticeStage.h"
#include "Structured/Lattice.h"
#include "Structured/LightNodes.h"
#include "Structured/StoredValues.h"
#include "Volume/MarchedVolume.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <memory>

namespace tetmarch
{

class StructuredVolume : public MarchedVolume
{
public:
  StructuredVolume() = default;
  StructuredVolume(const StructuredVolume&) = delete;
  StructuredVolume& operator=(const StructuredVolume&) = delete;

  /** The extent and the coordinates of the data, and the frame; the volume is empty if something
   * is wrong. Takes a vtkImageData (vtkUniformGrid, too) or a vtkRectilinearGrid, or leaves with
   * their values. Other data with the same coordinates keeps the lattice. */
  std::string updateGeometry(
    const VolumeInput& input, const ResourceLimits& limits, const Progress& progress) override;
  /**
   * The lattice that the array and the interpolation call for, its hidden cells, its values and
   * their ranges; there are no values if something is wrong. Each is made again when its own input
   * changed: a new array leaves the lattice, another interpolation leaves the values.
   */
  std::string updateScalars(const VolumeInput& input, const DrawnScalars& drawn) override;
  /** The distances to the blocks of which something may be seen. */
  std::string updateVisibility(const IntegralTable& first, const Components& parts,
    const Blending& blending, bool undrawnSeen) override;
  /** Rays enter a lattice by the planes of its sides. */
  std::string prepareEntrySearch() override { return {}; }

  bool isEmpty() const override { return this->Geometry.isEmpty(); }
  bool isHidden() const override
  {
    return areAllHidden(this->hiddenCells(), this->numberOfCells());
  }
  bool showsNothing() const override { return this->emptySpace().EmptyShare == 1; }
  bool isStructured() const override { return true; }
  bool takesSamples() const override { return !this->Leaves; }
  bool mayReenter() const override { return false; }
  const std::vector<ScalarRange>& extraRanges() const override { return this->ExtraRanges; }
  /** Cells of which nothing is seen are leapt over or skipped, if there are blocks of them. */
  double transparentShare(const IntegralTable&) const override
  {
    return this->emptySpace().EmptyShare;
  }
  /** A cell of the lattice may overlap eight cells of the data. */
  vtkIdType cellOf(std::uint32_t cell, const Vector3& point) const override;
  /** Two cells, or one if it has a value of its own. */
  double leastDetail() const override
  {
    return (this->Made.Constant ? 1 : 2) * leastSide(this->Made);
  }
  std::vector<OutlineEdge> outlineEdges() const override
  {
    return outlineEdgesOf(this->Frame.HalfExtent);
  }
  void setBits(VariantKey& key) const override;
  Fingerprint version() const override;
  std::int64_t runs() const override
  {
    return this->LatticeRecord.Runs + this->Hidden.record().Runs + this->ValuesRecord.Runs +
           this->RangesRecord.Runs + this->Empty.record().Runs;
  }
  void addTo(ReferenceScene& scene) const override;

  // As the effects of light see it. The march takes gradients from the values; light is kept at the
  // nodes of a coarser lattice in place of vertices.
  /** Known from updateGeometry() on; the rest of the lattice from updateScalars() on. */
  const VolumeFrame& frame() const override { return this->Frame; }
  const ScalarRange& range() const override { return this->Values.front().Range; }
  /** Equal as long as the lattice is the same. */
  Fingerprint geometryVersion() const override;
  /** Equal as long as the lattice and its values are the same. */
  Fingerprint scalarsVersion() const override;
  bool storesGradients() const override { return false; }
  bool hasCellGradients() const override { return !this->Made.Constant; }
  std::vector<std::array<float, 3>> gradients(bool, Group*) const override { return {}; }
  /** The numbers of the nodes along the axes. */
  std::vector<VertexStart> vertexStarts() const override;
  bool startPoint(std::size_t vertex, const VertexStart& start, Vector3& point) const override;

  const Lattice& lattice() const { return this->Made; }
  /** nullptr: the cells are those of the lattice. */
  const Octree* octree() const { return this->Leaves ? &this->Leaves->Tree : nullptr; }
  /** Of the lattice, or its leaves. */
  std::uint64_t numberOfCells() const
  {
    return this->Leaves ? this->Leaves->Count : this->Made.numberOfCells();
  }
  /** The data's planes along i, j, k in lattice coordinates, if the lattice has other planes. */
  std::array<std::vector<double>, 3> dataPlanes() const;
  /** Of the lattice. */
  const LightNodes& lightNodes() const { return this->Nodes; }
  /** The first scalar, and those that are drawn with it. */
  const std::vector<StoredValues>& values() const { return this->Values; }
  /** One bit for each cell of the lattice: bit c % 32 of word c / 32. Empty if none is hidden.
   * Which are: see hiddenLatticeCells(). */
  const std::vector<std::uint32_t>& hiddenCells() const { return this->Hidden.cells(); }
  /** Of the first scalar and, if they are independent, of those that are drawn with it: of others
   * nothing is seen where the first one has no opacity. */
  const std::vector<BlockRanges>& blockRanges() const { return this->Ranges; }
  const BlockDistances& emptySpace() const { return this->Empty.distances(); }
  /** Whether rays leap over what is empty. */
  bool leaps() const { return this->Leaps.isOn(); }
  /** Equal as long as the empty space is the same. */
  Fingerprint emptySpaceVersion() const { return this->Empty.version(); }
  /** Equal as long as the same cells of the same lattice are hidden; empty without ghost arrays. */
  const Fingerprint& hiddenVersion() const { return this->Hidden.version(); }

  const StageRecord& latticeRecord() const { return this->LatticeRecord; }
  const StageRecord& valuesRecord() const { return this->ValuesRecord; }
  const StageRecord& rangesRecord() const { return this->RangesRecord; }
  const StageRecord& emptySpaceRecord() const { return this->Empty.record(); }

private:
  std::string updateLattice(const LatticeCase& lies);
  std::string updateValues(const DrawnScalars& drawn);
  std::string updateRanges(ComponentMix mix);
  std::vector<ShownScalar> shownScalars(const IntegralTable& first, const Components& parts) const;
  void clearValues();

  GridGeometry Geometry;
  std::shared_ptr<const LeafPlaces> Leaves;
  VolumeFrame Frame;
  Fingerprint LatticeInput; // beside the geometry
  LatticeCase Case;
  Lattice Made;
  LightNodes Nodes;
  HiddenLatticeStage Hidden;
  Fingerprint ValuesInput;
  vtkSmartPointer<vtkDataArray> ValuesOfLeaves; // which the stored ones may be those of
  std::vector<StoredValues> Values;
  std::vector<ScalarRange> ExtraRanges;
  Fingerprint RangesInput;
  std::vector<BlockRanges> Ranges;
  EmptySpaceStage Empty;
  Switch Leaps;
  StageRecord LatticeRecord;
  StageRecord ValuesRecord;
  StageRecord RangesRecord;
};

} // namespace tetmarch

#endif
