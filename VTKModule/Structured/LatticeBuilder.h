// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The lattice of a grid, depending on the association of values and their interpolation.
#ifndef TetMarchStructuredLatticeBuilder_h
#define TetMarchStructuredLatticeBuilder_h

#include "Input/GridGeometry.h"
#include "Structured/Lattice.h"

#include <string>

namespace tetmarch
{

/** The interpolation type of a vtkVolumeProperty. */
enum class Interpolation : unsigned char
{
  Nearest,
  Linear
};

struct LatticeCase
{
  bool OfCells = false; // values of the data's cells, else of its points
  Interpolation Between = Interpolation::Nearest;
  /** Not 0: cells are parts of the leaves of an octree, whose values lie in an image with this many
   * along its axes. */
  std::array<int, 3> ValuesOfLeaves{};

  bool isOfLeaves() const { return this->ValuesOfLeaves[0] > 0; }
  bool operator==(const LatticeCase& other) const
  {
    return this->OfCells == other.OfCells && this->Between == other.Between &&
           this->ValuesOfLeaves == other.ValuesOfLeaves;
  }
  /** Whether cells of the lattice extend between centres of the data's cells, and to the ends of
   * the axis; else they are the data's cells. */
  bool isShifted() const { return this->OfCells == (this->Between == Interpolation::Linear); }
};

/** The geometry must be valid and not empty. Returns an empty string, or an error with its remedy.
 */
std::string makeLattice(const GridGeometry& geometry, const VolumeFrame& frame,
  const LatticeCase& lies, Lattice& lattice);

} // namespace tetmarch

#endif
