// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether clipping and cropping leave something of a box.
#ifndef TetMarchRaysClippedBox_h
#define TetMarchRaysClippedBox_h

#include <array>

namespace tetmarch
{

struct Clipping;

/** Whether nothing is left of the box with these half sides about the origin of the normalised
 * frame. A box that a plane touches counts as left. */
bool leavesNothing(const Clipping& clipping, const std::array<double, 3>& halfExtent);

} // namespace tetmarch

#endif
