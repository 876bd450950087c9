// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What of a picture is hidden by what the processes have gathered together.
#ifndef TetMarchProcessesHiddenDepths_h
#define TetMarchProcessesHiddenDepths_h

#include "Processes/Packing.h"
#include "Processes/Visits.h"

#include <vector>

namespace tetmarch
{

/** Of each pixel the depth behind which nothing is seen: no ray need enter a piece there.
 * NothingHidden if all of a ray may be seen. Empty if nothing is known of any pixel. */
using HiddenDepths = std::vector<float>;

/** The depths of a row of merged pixels, of the span in which something is hidden. */
void packHidden(const MergedPixel* row, int width, Packer& packer);
/** Those become the lesser of themselves and of what another process has packed. */
void takeHidden(Unpacker& sent, int width, float* row);

/** How many visits are hidden, by the depths of their pixels. */
std::size_t countHidden(const VisitLists& lists, const float* hidden);

} // namespace tetmarch

#endif
