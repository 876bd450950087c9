// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Depths behind which a process expects to be hidden, from the last picture.
#ifndef TetMarchProcessesExpectedDepths_h
#define TetMarchProcessesExpectedDepths_h

#include "Processes/HiddenDepths.h"

#include <cstddef>

namespace tetmarch
{

/** Parts hidden in the last picture are probably hidden in the next: rays wait there until the
 * processes have exchanged the hidden depths of this picture. This costs messages, so it is done
 * only if a large share of this process's visits was hidden. */
class ExpectedDepths
{
public:
  /** Begin the next picture. Depths of another size are discarded. */
  void begin(int width, int height);
  /** The expected depths of rows [first, end); empty if nothing is expected. */
  HiddenDepths ofRows(int first, int end) const;

  /** Record hidden depths from that row on: the minimum of all recorded ones. */
  void learn(int firstRow, const HiddenDepths& hidden);
  /** Complete the rows from that one on: the number of visits of this process there, and of its
   * rays that ended because their next entry was hidden. */
  void count(int firstRow, const std::vector<VisitLists>& visits, std::size_t endedRays);

private:
  std::ptrdiff_t startOf(int row) const { return static_cast<std::ptrdiff_t>(this->Width) * row; }

  int Width = 0;
  int Height = 0;
  HiddenDepths Expected; // by the last picture
  HiddenDepths Learned;  // of this one
  std::size_t Hidden = 0;
  std::size_t Seen = 0;
};

} // namespace tetmarch

#endif
