// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The leaves of VTK's adaptive data sets.
#ifndef TetMarchLeavesLeafList_h
#define TetMarchLeavesLeafList_h

#include "Blocks/BlockList.h"
#include "Leaves/Leaves.h"

#include "vtkType.h"

#include <string>

class vtkCellData;
class vtkDataArray;
class vtkHyperTreeGrid;
class vtkUniformGridAMR;

namespace tetmarch
{

/** Collects leaves, then orders them and their values. */
class LeafList
{
public:
  /** The values of a leaf: a tuple of the arrays of a source. */
  struct Origin
  {
    int Source;
    vtkIdType Tuple;
  };

  void add(const Leaf& leaf, bool shown, int source, vtkIdType tuple);
  const std::vector<Leaf>& shown() const { return this->Shown; }
  /** Of the leaves that are shown. */
  const std::vector<Origin>& origins() const { return this->Origins; }
  /** The leaves, with these arrays of each source: the same number for each, of equal component
   * counts; the result has the types of the first source. */
  Leaves made(
    std::array<LeafAxis, 3> axes, const std::vector<std::vector<vtkDataArray*>>& arrays) const;

private:
  std::vector<Leaf> Shown;
  std::vector<Origin> Origins; // of shown leaves
  std::vector<Leaf> Hidden;
};

/** The named arrays of numbers, but that of ghost cells. */
std::vector<vtkDataArray*> valueArraysOf(vtkCellData* data);
/** The name of the active scalars, or an empty string. */
std::string activeScalarsOf(vtkCellData* data);

/** The largest lattice of leaves, in cells along an axis. */
constexpr int MostLeafPlaces = 1 << 30;

using LeafAxes = std::array<LeafAxis, 3>;

//@{
/** The leaves without values, and the axes of their lattice. Returns an empty string, or an error
 * with its remedy. The blocks are those with cells in three dimensions, which must be sound; a tree
 * is one source. */
std::string listLeaves(
  vtkUniformGridAMR* data, const std::vector<Block>& blocks, LeafList& list, LeafAxes& axes);
std::string listLeaves(vtkHyperTreeGrid* tree, LeafList& list, LeafAxes& axes);
//@}

/** Whether the block is an image with cells in three dimensions. */
bool hasLeaves(const Block& block);

//@{
/** Returns an empty string, or an error with its remedy. Blanked, masked and ghost cells are
 * hidden; cells of blocks that finer blocks cover are left out. */
std::string findLeaves(vtkUniformGridAMR* blocks, Leaves& leaves);
std::string findLeaves(vtkHyperTreeGrid* tree, Leaves& leaves);
//@}

} // namespace tetmarch

#endif
