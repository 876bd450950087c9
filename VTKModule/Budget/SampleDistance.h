// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How far rays are apart, in pixels, so that a frame keeps the time that it is given.
#ifndef TetMarchBudgetSampleDistance_h
#define TetMarchBudgetSampleDistance_h

namespace tetmarch
{

class SampleDistance
{
public:
  /**
   * For a frame that may take so many seconds, by what the last one took; the time of a frame goes
   * with the number of its rays. Distances are powers of the root of 2, lest each frame have a
   * size of its own, from least to most (at least 1).
   */
  double choose(double seconds, double least, double most);
  /** A frame took so long with that distance. */
  void drawn(double distance, double seconds);
  bool knowsTime() const { return this->FullSeconds > 0; }

private:
  double FullSeconds = 0; // that a frame with a ray a pixel takes; 0: not known
  double Distance = 1;
};

} // namespace tetmarch

#endif
