// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of a row of pixels with data to send.
#ifndef TetMarchProcessesPixelSpan_h
#define TetMarchProcessesPixelSpan_h

#include "Processes/Packing.h"

#include <cstdint>

namespace tetmarch
{

/** Pixels [first, end). */
struct PixelSpan
{
  std::uint32_t First, End;
  std::uint32_t size() const { return this->End - this->First; }
};

/** From the first to the last pixel of a row with data; empty if there is none.
 */
template <typename Has>
PixelSpan spanOf(std::uint32_t width, const Has& has)
{
  PixelSpan span{ 0, width };
  while (span.First < span.End && !has(span.First))
  {
    ++span.First;
  }
  while (span.End > span.First && !has(span.End - 1))
  {
    --span.End;
  }
  return span;
}

/** Reads a span sent by another process. Throws a GroupFailure if it is invalid for the row. */
inline PixelSpan takeSpan(Unpacker& sent, std::uint32_t width)
{
  PixelSpan span{ 0, 0 };
  sent.take(&span, 1);
  if (span.First > span.End || span.End > width)
  {
    throw GroupFailure("What a process sent is no row of the picture.");
  }
  return span;
}

} // namespace tetmarch

#endif
