// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The leaves of VTK's adaptive data sets.
#ifndef TetMarchLeavesLeafList_h
#define TetMarchLeavesLeafList_h

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
  /** The values of a leaf are tuple `tuple` of the arrays of `source`. */
  void add(const Leaf& leaf, bool shown, int source, vtkIdType tuple);
  /** The leaves, with these arrays of each source: the same number for each, of equal component
   * counts; the result has the types of the first source. */
  Leaves made(
    std::array<LeafAxis, 3> axes, const std::vector<std::vector<vtkDataArray*>>& arrays) const;

private:
  struct Origin
  {
    int Source;
    vtkIdType Tuple;
  };
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

//@{
/** Returns an empty string, or an error with its remedy. Blanked, masked and ghost cells are
 * hidden; cells of blocks that finer blocks cover are left out. */
std::string findLeaves(vtkUniformGridAMR* blocks, Leaves& leaves);
std::string findLeaves(vtkHyperTreeGrid* tree, Leaves& leaves);
//@}

} // namespace tetmarch

#endif
