// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Sizes of the parts of work that is distributed over frames.
#ifndef TetMarchBudgetGrowingParts_h
#define TetMarchBudgetGrowingParts_h

#include <cstdint>

namespace tetmarch
{

/**
 * Parts grow while they take less than a quarter of the available time of a frame: parts of a
 * quarter are measured often enough to end in time, and the waits between them cost little. The
 * first part is sized for rays that take WorstRaySeconds each; no part is much smaller than
 * justifies a draw call.
 */
class GrowingParts
{
public:
  /** Begin work whose units take this number of rays each. */
  void begin(double raysOfUnit, double secondsOfFrame);
  /** The units of the next part: at least 1, and 8 unless they have too many rays. */
  std::int64_t next() const { return this->Units; }
  /** Record the time of a part of this number of units: fewer than next() if there was no room. */
  void done(std::int64_t units, double seconds);

private:
  double Limit = 0; // maximum seconds of a part
  std::int64_t LeastUnits = 1;
  std::int64_t Units = 1;
};

} // namespace tetmarch

#endif
