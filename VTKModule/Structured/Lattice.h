// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of a structured volume, through which rays march, and their stored values.
#ifndef TetMarchStructuredLattice_h
#define TetMarchStructuredLattice_h

#include "Geometry/VolumeFrame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/**
 * One axis of a lattice: planes divide it into cells. Lattice coordinates are 0 in the middle of
 * the axis, and 1 is the mean distance of samples.
 */
struct LatticeAxis
{
  int Cells = 0;
  int Values = 0; // number of values along the axis
  /**
   * A trilinear cell i has the values i + FirstValue and i + FirstValue + 1 at its ends, a constant
   * cell the value i + FirstValue. Indices are clamped to 0 .. Values - 1, so that cells outside
   * the outermost values are constant along the axis.
   */
  int FirstValue = 0;
  /** Without Planes, plane i, of 0 .. Cells, is at clamp(i + Shift, -HalfLength, HalfLength). */
  double Shift = 0;
  double HalfLength = 0;
  /** For a rectilinear axis: the positions of all planes, ascending. */
  std::vector<float> Planes;

  bool isUniform() const { return this->Planes.empty(); }
  double plane(int i) const
  {
    return this->isUniform() ? std::clamp(i + this->Shift, -this->HalfLength, this->HalfLength)
                             : static_cast<double>(this->Planes[i]);
  }
};

struct Lattice
{
  std::array<LatticeAxis, 3> Axes; // i, j, k; values and cells are numbered with i fastest
  bool Constant = false;           // each cell has one value; else it is trilinear
  VolumeFrame Frame;
  /** Row-major 3 x 4: from the normalised frame to lattice coordinates. */
  std::array<double, 12> FromNormalized{};

  std::uint64_t numberOfCells() const
  {
    return std::uint64_t(this->Axes[0].Cells) * this->Axes[1].Cells * this->Axes[2].Cells;
  }
  std::uint64_t numberOfValues() const
  {
    return std::uint64_t(this->Axes[0].Values) * this->Axes[1].Values * this->Axes[2].Values;
  }
  bool isUniform() const
  {
    return this->Axes[0].isUniform() && this->Axes[1].isUniform() && this->Axes[2].isUniform();
  }
};

/** The least distance of neighbouring planes, in the normalised frame. */
inline double leastSide(const Lattice& lattice)
{
  double least = HUGE_VAL;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double* row = &lattice.FromNormalized[4 * axis];
    const double planesPerUnit = std::hypot(row[0], row[1], row[2]);
    const std::vector<float>& planes = lattice.Axes[axis].Planes;
    double distance = 1;
    for (std::size_t i = 1; i < planes.size(); ++i)
    {
      distance = std::min(distance, double(planes[i]) - double(planes[i - 1]));
    }
    least = std::min(least, distance / planesPerUnit);
  }
  return least;
}

/** Maximum number of cells that a ray crosses: each plane is crossed at most once. */
inline int mostCellsOf(const Lattice& lattice)
{
  return lattice.Axes[0].Cells + lattice.Axes[1].Cells + lattice.Axes[2].Cells;
}

} // namespace tetmarch

#endif
