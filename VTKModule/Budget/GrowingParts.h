// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Sizes of the parts of a work that is spread over frames.
#ifndef TetMarchBudgetGrowingParts_h
#define TetMarchBudgetGrowingParts_h

#include <cstdint>

namespace tetmarch
{

/**
 * A part grows while it takes less than a quarter of what a frame can spare: then a part of a
 * quarter is measured often enough to end in time, and the waiting between parts costs little. The
 * first part is as large as would be right if each ray took WorstRaySeconds; no part is much
 * smaller than a draw call is worth.
 */
class GrowingParts
{
public:
  /** Begin a work whose units take this number of rays each. */
  void begin(double raysOfUnit, double secondsOfFrame);
  /** The units of the next part: at least 1, and 8 unless they have too many rays. */
  std::int64_t next() const { return this->Units; }
  /** How long a part of this number of units took: fewer than next() if there was no room. */
  void done(std::int64_t units, double seconds);

private:
  double Limit = 0; // seconds of a part
  std::int64_t LeastUnits = 1;
  std::int64_t Units = 1;
};

} // namespace tetmarch

#endif
