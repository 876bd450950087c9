// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of a grid that aren't ghosts.
#ifndef TetMarchBlocksOwnCells_h
#define TetMarchBlocksOwnCells_h

#include "Blocks/CellOrigins.h"
#include "Caching/Fingerprint.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace tetmarch
{

/** A grid without the cells that vtkGhostType marks as duplicates: another process draws them, or
 * the grid has them again. Of equal cells the mesh keeps the first, which may be the ghost. */
class OwnCells
{
public:
  /** scalars: of the cells or points of the grid; may be nullptr. Invalid data (checkData,
   * checkScalars) stay as they are. */
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
