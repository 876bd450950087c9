// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The accuracy levels from which a budget chooses.
#ifndef TetMarchBudgetAccuracyLadder_h
#define TetMarchBudgetAccuracyLadder_h

#include "Optics/AccuracyLevel.h"

#include <vector>

namespace tetmarch
{

/** The user's settings. With a budget, level and tolerance are ignored. */
struct AccuracyOptions
{
  Accuracy Level = Accuracy::Default;
  double ErrorTolerance = DefaultAccuracy.ErrorTolerance;
  double FrameTimeBudget = 0; // seconds; 0: none
  double ErrorBudget = 0;     // of a channel of a pixel, 0..1; 0: none
};

struct Rung
{
  Accuracy Level = Accuracy::Default;
  double Tolerance = DefaultAccuracy.ErrorTolerance; // the guaranteed error; 0: none

  bool operator==(const Rung& other) const
  {
    return this->Level == other.Level && this->Tolerance == other.Tolerance;
  }
  AccuracyLevel level() const { return levelOf(this->Level, this->Tolerance); }
};

/** The level set by the user. */
inline Rung rungOf(Accuracy accuracy, double tolerance)
{
  const AccuracyLevel level = levelOf(accuracy, tolerance);
  return { accuracy, level.Adaptive ? level.ErrorTolerance : 0.0 };
}

/** The minimum tolerance that can be set. */
constexpr double LeastTolerance = 1e-6;

/**
 * The candidates, from the cheapest to the best; without a time budget there is one.
 *
 * Default with the tolerance of an error budget is the cheapest level that keeps it. Fast is no
 * candidate: for point scalars it guarantees no error, and measuring its error bound takes a march
 * that costs more than the adaptive frame that it would save. For cell scalars both levels are the
 * same shader, in which only the end of a ray is inexact; Fast could guarantee 1/512, with which
 * Default ends rays as early, and earlier with a larger tolerance. The tables of Fast have 1024
 * entries even if their error exceeds that of Default (FittingTable.h).
 */
inline std::vector<Rung> ladderOf(const AccuracyOptions& options)
{
  std::vector<Rung> ladder;
  if (options.ErrorBudget > 0)
  {
    ladder.push_back({ Accuracy::Default, std::max(options.ErrorBudget, LeastTolerance) });
  }
  else if (!(options.FrameTimeBudget > 0))
  {
    ladder.push_back(rungOf(options.Level, options.ErrorTolerance));
  }
  if (options.FrameTimeBudget > 0)
  {
    for (const Rung& rung : { rungOf(Accuracy::Fast, 1.0), rungOf(Accuracy::Default, 1.0 / 32.0),
           rungOf(Accuracy::Default, DefaultAccuracy.ErrorTolerance),
           rungOf(Accuracy::Accurate, 1.0), rungOf(Accuracy::Reference, 1.0) })
    {
      const bool better = rung.Tolerance > 0 && rung.Tolerance < options.ErrorBudget;
      if (better || !(options.ErrorBudget > 0))
      {
        ladder.push_back(rung);
      }
    }
  }
  return ladder;
}

} // namespace tetmarch

#endif
