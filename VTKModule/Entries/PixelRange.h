// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A rectangle of pixels.
#ifndef TetMarchEntriesPixelRange_h
#define TetMarchEntriesPixelRange_h

namespace tetmarch
{

/** From Left to before Right, from Bottom to before Top. */
struct PixelRange
{
  int Left;
  int Bottom;
  int Right;
  int Top;
};

} // namespace tetmarch

#endif
