// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Curved cells within a tolerance.
 */
#ifndef tetmarch_CurvedCells_h
#define tetmarch_CurvedCells_h

#include "ProgressBar.h"
#include "VolumeData.h"

#include "vtkUnstructuredGrid.h"

namespace tetmarch
{

/// The grid with its curved cells cut into tetrahedra, as vtkTetMarchTessellator does, whose
/// scalars are those of the wanted array, or of the one that vtkTetMarchFirstPicture chooses.
/// Throws Failure that says why that can't be, and Cancelled if the report asks to stop.
vtkSmartPointer<vtkUnstructuredGrid> CutCurvedCells(
  vtkUnstructuredGrid* grid, const WantedArray& wanted, const ProgressReport& report);

} // namespace tetmarch

#endif
