// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The ghost arrays of a data set, which hide cells, and their bits.
#ifndef TetMarchScalarsGhostArrays_h
#define TetMarchScalarsGhostArrays_h

#include "vtkDataSetAttributes.h"

#include <vector>

class vtkDataSet;
class vtkUnsignedCharArray;

namespace tetmarch
{

/** A cell with one of these bits is hidden: it is blanked, refined by finer cells, or drawn by
 * another process. */
constexpr unsigned char HidingCell = vtkDataSetAttributes::DUPLICATECELL |
                                     vtkDataSetAttributes::REFINEDCELL |
                                     vtkDataSetAttributes::HIDDENCELL;
/** A cell with a point with this bit is hidden. */
constexpr unsigned char HidingPoint = vtkDataSetAttributes::HIDDENPOINT;

/** The arrays vtkGhostType of cells and of points. nullptr if there is none, if it is not of
 * unsigned char, or if it does not have one value for each cell or point. */
struct GhostArrays
{
  vtkUnsignedCharArray* OfCells = nullptr;
  vtkUnsignedCharArray* OfPoints = nullptr;
};
GhostArrays ghostArraysOf(vtkDataSet* data);

/** Whether some value has one of the bits. */
bool hasAny(vtkUnsignedCharArray* ghosts, unsigned char bits);

/** For each cell whether one of its points is hidden, by this array of points. */
std::vector<bool> cellsOfHiddenPoints(vtkDataSet* grid, vtkUnsignedCharArray* ofPoints);

} // namespace tetmarch

#endif
