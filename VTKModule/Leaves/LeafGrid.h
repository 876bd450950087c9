// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The leaves of an adaptive mesh as rays march through them: boxes of the cells of a lattice, and a
// value for each.
#ifndef TetMarchLeavesLeafGrid_h
#define TetMarchLeavesLeafGrid_h

#include "Blocks/CellOrigins.h"
#include "Blocks/MissingScalars.h"
#include "Caching/Fingerprint.h"
#include "Caching/StageRecord.h"
#include "Input/GridGeometry.h"
#include "Structured/Octree.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkImageData;

namespace tetmarch
{

/** Where the leaves are. */
struct LeafPlaces
{
  GridGeometry Geometry; // of the lattice of the smallest leaves
  Octree Tree;
  std::size_t Count = 0; // of the leaves
  /** Whether the leaves fill the lattice. If not, what they leave out has the number Count. */
  bool Fill = true;
};

class LeafGrid
{
public:
  /**
   * Take the leaves of a vtkHyperTreeGrid or an AMR data set with values of cells, which differ in
   * size by powers of two. Returns false for any other data, also if it isn't sound or memory is
   * lacking: then there is nothing. If only the values have changed, the places stay.
   */
  bool update(vtkDataObject* input, const ScalarSelection& selection);
  void clear();

  /** nullptr: there are none. Another object if the places have changed. */
  const std::shared_ptr<const LeafPlaces>& places() const { return this->Places; }
  /** An image whose cells are the leaves in their order, with a value each: its sides are those
   * that OctreeRowShift says. Cells beyond the leaves repeat a value; that number Count is hidden.
   */
  vtkImageData* values() const;
  vtkDataArray* scalars() const;
  /** The cells of the input: of a tree its leaves in their order. */
  const CellOrigins& origins() const { return this->Origins; }
  /** The number of times that it was made. */
  const StageRecord& record() const { return this->Record; }

private:
  struct Input;
  static bool readInput(vtkDataObject* data, const ScalarSelection& selection, Input& input);
  void make(const Input& input);
  void place(const Input& input);
  void gather(const Input& input);

  Fingerprint Shape;
  Fingerprint ValuesFrom;
  std::shared_ptr<const LeafPlaces> Places;
  std::vector<vtkIdType> Tuples; // of each leaf, numbered through all sources
  vtkSmartPointer<vtkImageData> Values;
  CellOrigins Origins;
  StageRecord Record;
};

} // namespace tetmarch

#endif
