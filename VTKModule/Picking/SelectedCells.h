// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a vtkHardwareSelector is told of picked points: it renders several times, and reads from the
// colours of each pass one number a pixel.
#ifndef TetMarchPickingSelectedCells_h
#define TetMarchPickingSelectedCells_h

#include "Blocks/CellOrigins.h"
#include "Picking/PickedPoint.h"
#include "Rays/View.h"

#include <vector>

class vtkHardwareSelector;

namespace tetmarch
{

/** Whether the pass that the selector is in is about cells, or about whose they are. */
bool asksForCells(vtkHardwareSelector* selector);

/**
 * Red, green and blue, 0..1, and the depth of the window, 0..1, for each of the points; a depth of
 * 1 for those that hit nothing. Cells are those of the input grid, or of the block of the input.
 */
std::vector<float> selectionTexels(vtkHardwareSelector* selector,
  const std::vector<PickedPoint>& points, const CellOrigins& origins, const View& view);

} // namespace tetmarch

#endif
