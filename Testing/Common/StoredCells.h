// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A curvilinear grid with stored cells
 */
#ifndef tetmarch_testing_StoredCells_h
#define tetmarch_testing_StoredCells_h

#include "GridBuilder.h"

#include "Mesh/CurvilinearMesh.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"

namespace tetmarch::testing
{
/// Its hexahedra, with its arrays.
inline Grid withStoredCells(vtkStructuredGrid* grid)
{
  Grid hexahedra = tetmarch::hexahedraOf(grid);
  hexahedra->GetPointData()->ShallowCopy(grid->GetPointData());
  hexahedra->GetCellData()->ShallowCopy(grid->GetCellData());
  return hexahedra;
}
} // namespace tetmarch::testing

#endif
