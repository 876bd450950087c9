// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a process expects to be hidden from picture to picture.
#ifndef TetMarchProcessesExpectedDepths_h
#define TetMarchProcessesExpectedDepths_h

#include "Processes/HiddenDepths.h"

#include <cstddef>

namespace tetmarch
{

/** What was hidden in the last picture will most likely be so in the next: there rays wait until
 * the processes have told what is hidden now. That costs messages, so it is done only if much of
 * what this process had to march was hidden. */
class ExpectedDepths
{
public:
  /** Of the next picture. What was learned of another size is forgotten. */
  void begin(int width, int height);
  /** Of the rows from one to before the other; empty if nothing is expected. */
  HiddenDepths ofRows(int first, int end) const;

  /** What is hidden from that row on: the least depths of all that is said. */
  void learn(int firstRow, const HiddenDepths& hidden);
  /** When all is learned of the rows from that one on: the visits of this process there, and how
   * many rays have ended because what they would have entered was hidden. */
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
