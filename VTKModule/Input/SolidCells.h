// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Tests for 3D cells.
#ifndef TetMarchInputSolidCells_h
#define TetMarchInputSolidCells_h

class vtkDataSet;

namespace tetmarch
{

/** Whether cells of this type (VTK_TETRA and so on) are three-dimensional. True for unknown types,
 * which checkData() reports. */
bool isSolidType(int type);

/** Whether the data have any 3D cell. They may be invalid (checkData). */
bool hasSolidCells(vtkDataSet* data);

/** Whether the data are an image or a rectilinear grid with at most one point along an axis. */
bool isSlice(vtkDataSet* data);

} // namespace tetmarch

#endif
