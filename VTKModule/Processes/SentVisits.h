// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The visits of rows of pixels, as one process sends them to another.
#ifndef TetMarchProcessesSentVisits_h
#define TetMarchProcessesSentVisits_h

#include "Processes/PixelSpan.h"
#include "Processes/Visits.h"

namespace tetmarch
{

/** The visits of the rows that a process merges: of each row from the first to the last pixel with
 * visits a number of visits, then the visits. */
Bytes packVisits(const VisitLists& lists, int merger, int processes);

/** Those that one process has sent, of one row. */
struct SentRow
{
  PixelSpan Where{ 0, 0 };
  std::vector<std::uint32_t> Starts; // in Visits, of each pixel of the span, and the end
  std::vector<Visit> Visits;

  /** Appends the visits of a pixel. */
  void collect(std::uint32_t x, std::vector<Visit>& visits) const;
};

SentRow takeRow(Unpacker& sent, std::uint32_t width);

} // namespace tetmarch

#endif
