// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the best level of accuracy that keeps a frame time, from the times of drawn frames.
#ifndef TetMarchBudgetLevelController_h
#define TetMarchBudgetLevelController_h

#include <array>

namespace tetmarch
{

/** The significance of a frame's time for its level. */
enum class FrameKind
{
  Measured,  // it was completed without other work
  Disturbed, // other work was done as well, or the frame was not completed
  Changed    // as Disturbed, and past frames had other data, functions or size
};

/**
 * Levels are numbered from the cheapest, 0. The only assumption about costs is that a better level
 * costs more; for the first frame's level and those below it even this may be wrong:
 *
 * - The next better level, if its time is unknown, is tried for one measured frame: at once if the
 *   current level takes at most half of the budget, so that the trial takes at most k / 2 budgets,
 *   where k is the ratio of both times; else when the current level has been measured `Patience`
 *   times and keeps the budget, since the next level may cost little more. Such a trial takes at
 *   most k budgets, and is not repeated if it exceeds the budget.
 * - A level that exceeds the budget is left at once for the best lower level that is known to keep
 *   it, else for the cheapest: level 0, unless the first level was measured to be about as cheap.
 * - The times of other levels are scaled in proportion to that of the current one, for example when
 *   the camera moves. A level that was left is used again when its expected time keeps the budget
 *   and is clearly less than when it was left.
 * - Times are averaged over about eight frames. One outlier by a factor of 1.6 is treated as a
 *   disturbance, two in a row as a change.
 * - After other changes, the current level is on trial again. While frames are not measured, it is
 *   abandoned after `MostUnmeasured` consecutive frames above the budget.
 */
class LevelController
{
public:
  static constexpr int MostLevels = 6;
  static constexpr int Patience = 8;
  static constexpr int MostUnmeasured = 3;

  /** Set the number of levels, 1 to MostLevels, and the first one to draw. Forget their times. */
  void restart(int levels, int first = 0);
  /** Set the budget in seconds. The known times of levels are kept. */
  void setBudget(double seconds);
  /** The level to draw. */
  int level() const { return this->Current; }
  /** Record the time of a frame of the level, in seconds. */
  void drawn(double seconds, FrameKind kind);

private:
  bool isKnown(int level) const { return this->Past[level].Seconds > 0; }
  bool mayFit(int level) const;
  void measure(double seconds);
  void scaleOthers(double factor);
  void choose();
  int best() const;
  int cheapest() const;
  void leave();
  void use(int level);

  struct Memory
  {
    double Seconds = 0;  // expected now; 0: never measured
    double WhenLeft = 0; // the same when it exceeded the budget; 0: it didn't
  };
  std::array<Memory, MostLevels> Past{};
  int Levels = 1;
  int First = 0;
  int Current = 0;
  double Budget = 0;
  int Count = 0;        // number of measurements of the current level's expected time
  bool Arrived = false; // one of these was made after the switch to the level
  double Outlier = 0;   // the last measurement, if it was far off
  int Unmeasured = 0;   // consecutive frames above the budget
};

} // namespace tetmarch

#endif
