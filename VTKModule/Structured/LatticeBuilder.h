// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The lattice of a grid's points, by where the values are and how they are interpolated.
#ifndef TetMarchStructuredLatticeBuilder_h
#define TetMarchStructuredLatticeBuilder_h

#include "Input/GridGeometry.h"
#include "Structured/Lattice.h"

#include <string>

namespace tetmarch
{

/** How values are interpolated: that of a vtkVolumeProperty. */
enum class Interpolation : unsigned char
{
  Nearest,
  Linear
};

struct LatticeCase
{
  bool OfCells = false; // the values are those of the data's cells, else of its points
  Interpolation Between = Interpolation::Nearest;

  bool operator==(const LatticeCase& other) const
  {
    return this->OfCells == other.OfCells && this->Between == other.Between;
  }
  /** Whether cells of the lattice reach from centre to centre of the data's cells, and to the ends
   * of the axis; else they are the data's cells. */
  bool isShifted() const { return this->OfCells == (this->Between == Interpolation::Linear); }
};

/** Of a geometry that is not empty and nothing is wrong with. Returns an empty string, or what is
 * wrong and what to do. */
std::string makeLattice(const GridGeometry& geometry, const VolumeFrame& frame,
  const LatticeCase& lies, Lattice& lattice);

} // namespace tetmarch

#endif
