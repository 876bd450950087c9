// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Serialization of the visits of rows of pixels.
#ifndef TetMarchProcessesSentVisits_h
#define TetMarchProcessesSentVisits_h

#include "Processes/PixelSpan.h"
#include "Processes/Visits.h"

namespace tetmarch
{

/** Pack the visits of the rows that a process merges: for each row, from the first to the last
 * pixel with visits, the numbers of visits, then the visits. */
Bytes packVisits(const VisitLists& lists, int merger, int processes);

/** The visits of one row sent by one process. */
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
