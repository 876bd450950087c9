// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of a grid that this process draws, if several have pieces of a volume.
#ifndef TetMarchBlocksOwnCells_h
#define TetMarchBlocksOwnCells_h

#include "Blocks/CellOrigins.h"
#include "Caching/Fingerprint.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace tetmarch
{

/** A grid without the cells that vtkGhostType marks as duplicates, since another process draws
 * them. */
class OwnCells
{
public:
  /** scalars: of the cells or points of the grid; may be nullptr. */
  void update(
    vtkUnstructuredGrid* grid, vtkDataArray* scalars, bool ofCells, const CellOrigins& origins);

  /** The given grid if it has no duplicates. */
  vtkUnstructuredGrid* grid() const { return this->Grid; }
  vtkDataArray* scalars() const { return this->Scalars; }
  /** The given origins of the remaining cells. */
  const CellOrigins& origins() const { return this->Origins; }

private:
  Fingerprint MadeFrom;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkSmartPointer<vtkDataArray> Scalars;
  CellOrigins Origins;
};

} // namespace tetmarch

#endif
