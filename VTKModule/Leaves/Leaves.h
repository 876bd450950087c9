// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The leaves of an adaptive mesh: boxes that don't overlap.
#ifndef TetMarchLeavesLeaves_h
#define TetMarchLeavesLeaves_h

#include "Geometry/Vector3.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkDataArray;

namespace tetmarch
{

/** A place on the lattice of the smallest leaves. */
using LeafPlace = std::array<int, 3>;

/** The positions of the lattice's places along an axis: cells of equal widths between breaks. */
struct LeafAxis
{
  std::vector<double> Breaks; // ascending, at least two
  int CellsBetweenBreaks = 1;

  double position(int place) const
  {
    const auto last = static_cast<int>(this->Breaks.size()) - 2;
    const int before =
      place / this->CellsBetweenBreaks > last ? last : place / this->CellsBetweenBreaks;
    const double share = static_cast<double>(place - before * this->CellsBetweenBreaks) /
                         static_cast<double>(this->CellsBetweenBreaks);
    return (1 - share) * this->Breaks[before] + share * this->Breaks[before + 1];
  }
};

/** The box from Low to Low + Size. */
struct Leaf
{
  LeafPlace Low{};
  LeafPlace Size{};
};

struct Leaves
{
  std::array<LeafAxis, 3> Axes;
  /** Leaves [0, Shown) are drawn; masked and blanked ones follow. */
  std::vector<Leaf> All;
  std::size_t Shown = 0;
  /** One tuple for each leaf that is drawn. */
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
  std::string ActiveScalars; // the name of their array, or empty

  bool isShown(int leaf) const { return leaf >= 0 && static_cast<std::size_t>(leaf) < this->Shown; }
  double low(int leaf, int axis) const
  {
    return this->Axes[axis].position(this->All[leaf].Low[axis]);
  }
  double high(int leaf, int axis) const
  {
    return this->Axes[axis].position(this->All[leaf].Low[axis] + this->All[leaf].Size[axis]);
  }
  double center(int leaf, int axis) const
  {
    return 0.5 * (this->low(leaf, axis) + this->high(leaf, axis));
  }
  Vector3 center(int leaf) const
  {
    return { { this->center(leaf, 0), this->center(leaf, 1), this->center(leaf, 2) } };
  }
};

} // namespace tetmarch

#endif
