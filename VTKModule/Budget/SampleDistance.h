// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Chooses the distance between rays, in pixels, such that a frame keeps its time.
#ifndef TetMarchBudgetSampleDistance_h
#define TetMarchBudgetSampleDistance_h

namespace tetmarch
{

class SampleDistance
{
public:
  /**
   * The distance for a frame that may take this number of seconds, assuming that its time is
   * proportional to the number of rays. Distances are powers of the square root of 2, so that sizes
   * rarely change, between least (at least 1) and most.
   */
  double choose(double seconds, double least, double most);
  /** Record the seconds of a frame with this distance. */
  void drawn(double distance, double seconds);
  bool knowsTime() const { return this->FullSeconds > 0; }

private:
  double FullSeconds = 0; // of a frame with one ray per pixel; 0: not known
  double Distance = 1;
};

} // namespace tetmarch

#endif
