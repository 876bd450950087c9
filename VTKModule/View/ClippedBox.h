// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Tests whether a part of a box remains after clipping and cropping.
#ifndef TetMarchViewClippedBox_h
#define TetMarchViewClippedBox_h

#include <array>

namespace tetmarch
{

struct Clipping;

/** Whether no part remains of the box with these half sides about the origin of the normalised
 * frame. A box that touches a plane remains. */
bool leavesNothing(const Clipping& clipping, const std::array<double, 3>& halfExtent);

} // namespace tetmarch

#endif
