// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The colours from which a vtkHardwareSelector reads picked points: it renders several passes, and
// reads one number per pixel from the colours of each.
#ifndef TetMarchPickingSelectedCells_h
#define TetMarchPickingSelectedCells_h

#include "Blocks/CellOrigins.h"
#include "Picking/PickedPoint.h"
#include "View/View.h"

#include <vector>

class vtkHardwareSelector;

namespace tetmarch
{

/** Whether the current pass of the selector selects cells, or their prop or block. */
bool asksForCells(vtkHardwareSelector* selector);

/** For each point red, green and blue, 0..1, and the window depth, 0..1, which is 1 if nothing is
 * hit. Cell ids are those of the input grid, or of a block of the input. */
std::vector<float> selectionTexels(vtkHardwareSelector* selector,
  const std::vector<PickedPoint>& points, const CellOrigins& origins, const View& view);

} // namespace tetmarch

#endif
