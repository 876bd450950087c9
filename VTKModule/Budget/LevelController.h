// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds out which of several levels of accuracy keeps a frame time best, from the frames that were
// drawn.
#ifndef TetMarchBudgetLevelController_h
#define TetMarchBudgetLevelController_h

#include <array>

namespace tetmarch
{

/** What the time of a frame says about its level. */
enum class FrameKind
{
  Measured,  // it was drawn, and nothing else was done
  Disturbed, // other work was done as well, or the frame was left unfinished
  Changed    // as Disturbed, and past frames were of something else: data, functions, size
};

/**
 * Levels are numbered from the cheapest, 0, with which it begins. Nothing is assumed of what a
 * level costs but that the better one costs more:
 *
 * - A level whose time is not known is tried for one measured frame if it is the next better one:
 *   at once if the current level takes at most half of the budget, so that the trial stays below
 *   k / 2 budgets, where k is how many times as long it takes; else when the current level has been
 *   measured `Patience` times and keeps the budget, for the best level that fits may cost little
 *   more. Such a trial stays below k budgets, and if it breaks the budget it was the last.
 * - A level whose time is beyond the budget is left at once for the best one below that is known to
 *   keep it, else for the cheapest.
 * - The times of other levels follow those of the current one in proportion: so a camera move ages
 *   them. A level that was left is used again when it is expected to keep the budget and to take
 *   clearly less than when it was left.
 * - Times are averaged over about eight frames. One by a factor of 1.6 off is taken for a
 *   disturbance, two in a row for a change.
 * - After something else changed, the current level is on trial again. As long as frames are not
 *   measured, it is given up after `MostUnmeasured` in a row that took longer than the budget.
 */
class LevelController
{
public:
  static constexpr int MostLevels = 6;
  static constexpr int Patience = 8;
  static constexpr int MostUnmeasured = 3;

  /** From now on there are so many levels, 1 to MostLevels, of which nothing is known. */
  void restart(int levels);
  /** Set the budget in seconds. The known times of levels are kept. */
  void setBudget(double seconds);
  /** The level to draw with. */
  int level() const { return this->Current; }
  /** What a frame of that level took, in seconds. */
  void drawn(double seconds, FrameKind kind);

private:
  bool isKnown(int level) const { return this->Past[level].Seconds > 0; }
  bool mayFit(int level) const;
  void measure(double seconds);
  void scaleOthers(double factor);
  void choose();
  int best() const;
  void leave();
  void use(int level);

  struct Memory
  {
    double Seconds = 0;  // expected now; 0: never measured
    double WhenLeft = 0; // the same when it broke the budget; 0: it didn't
  };
  std::array<Memory, MostLevels> Past{};
  int Levels = 1;
  int Current = 0;
  double Budget = 0;
  int Count = 0;        // measurements behind what the current level is expected to take
  bool Arrived = false; // one of these is from after the switch to the level
  double Outlier = 0;   // the last measurement, if it was far off
  int Unmeasured = 0;   // frames in a row, longer than the budget
};

} // namespace tetmarch

#endif
