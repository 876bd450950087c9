// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Chooses the distance between rays, in pixels, so that a frame keeps its time.
#ifndef TetMarchBudgetSampleDistance_h
#define TetMarchBudgetSampleDistance_h

namespace tetmarch
{

class SampleDistance
{
public:
  /**
   * The distance for a frame that may take so many seconds. The time of a frame is taken to be
   * proportional to the number of its rays. Distances are powers of the square root of 2, so that
   * not every frame has a size of its own, between least (at least 1) and most.
   */
  double choose(double seconds, double least, double most);
  /** A frame with that distance took so many seconds. */
  void drawn(double distance, double seconds);
  bool knowsTime() const { return this->FullSeconds > 0; }

private:
  double FullSeconds = 0; // that a frame with a ray a pixel takes; 0: not known
  double Distance = 1;
};

} // namespace tetmarch

#endif
