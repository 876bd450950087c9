// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Depths behind which pixels are hidden by the visits of all processes.
#ifndef TetMarchProcessesHiddenDepths_h
#define TetMarchProcessesHiddenDepths_h

#include "Processes/Packing.h"
#include "Processes/Visits.h"

#include <vector>

namespace tetmarch
{

/** For each pixel the depth behind which nothing is visible, so that its ray need not enter a piece
 * there. NothingHidden if the whole ray may be visible. Empty if nothing is known. */
using HiddenDepths = std::vector<float>;

/** Pack the depths of a row of merged pixels, in the span of pixels with a hidden depth. */
void packHidden(const MergedPixel* row, int width, Packer& packer);
/** Set the depths to the minimum of themselves and of those packed by another process. */
void takeHidden(Unpacker& sent, int width, float* row);

/** The number of visits hidden by the depths of their pixels. */
std::size_t countHidden(const VisitLists& lists, const float* hidden);

} // namespace tetmarch

#endif
