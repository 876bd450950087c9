// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether there is a volume to draw.
#ifndef TetMarchInputSolidCells_h
#define TetMarchInputSolidCells_h

class vtkDataSet;

namespace tetmarch
{

/** Whether cells of this type (VTK_TETRA and so on) are three-dimensional. What is no type of
 * VTK counts as such: checkData() tells of it. */
bool isSolidType(int type);

/** Whether the data has any 3D cell. It may be unsound (checkData). */
bool hasSolidCells(vtkDataSet* data);

/** Whether the data is an image or a rectilinear grid with one point along an axis, or none. */
bool isSlice(vtkDataSet* data);

} // namespace tetmarch

#endif
