// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The accuracy levels from which a budget chooses.
#ifndef TetMarchBudgetAccuracyLadder_h
#define TetMarchBudgetAccuracyLadder_h

#include "Optics/AccuracyLevel.h"

#include <vector>

namespace tetmarch
{

/** The user's settings. With a budget, level and error tolerance are ignored. */
struct AccuracyOptions
{
  Accuracy Level = Accuracy::Default;
  double ErrorTolerance = DefaultAccuracy.ErrorTolerance;
  double FrameTimeBudget = 0; // seconds; 0: none
  double ErrorBudget = 0;     // of a channel of a pixel, 0..1; 0: none
  double PixelTolerance = 0;  // of adaptive pictures; 0: a ray for each pixel
};

struct Rung
{
  Accuracy Level = Accuracy::Default;
  double Tolerance = DefaultAccuracy.ErrorTolerance; // the guaranteed error of a ray; 0: none
  double PixelTolerance = 0;                         // 0: a ray for each pixel

  bool operator==(const Rung& other) const
  {
    return this->Level == other.Level && this->Tolerance == other.Tolerance &&
           this->PixelTolerance == other.PixelTolerance;
  }
  AccuracyLevel level() const { return levelOf(this->Level, this->Tolerance); }
};

/** The level set by the user. */
inline Rung rungOf(Accuracy accuracy, double tolerance, double pixelTolerance = 0)
{
  const AccuracyLevel level = levelOf(accuracy, tolerance);
  return { accuracy, level.Adaptive ? level.ErrorTolerance : 0.0, pixelTolerance };
}

/** The tolerance of pixels of the cheapest rung. */
constexpr double RungPixelTolerance = 4.0 / 255.0;

/** The index of the rung to begin with: the cheapest with the PixelTolerance that is set. */
inline int firstOf(const std::vector<Rung>& ladder)
{
  return ladder.size() > 1 && ladder[0].PixelTolerance > ladder[1].PixelTolerance ? 1 : 0;
}

/** The minimum tolerance that can be set. */
constexpr double LeastTolerance = 1e-6;

/**
 * The candidates, from the cheapest to the best; without a time budget there is one.
 *
 * The cheapest is Fast with interpolated pixels. Their error is an estimate, so an error budget
 * excludes it, and the user may have set another PixelTolerance, which all candidates have.
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
  const auto rung = [&](Accuracy level, double tolerance)
  { return rungOf(level, tolerance, options.PixelTolerance); };
  std::vector<Rung> ladder;
  if (options.ErrorBudget > 0)
  {
    ladder.push_back(rung(Accuracy::Default, std::max(options.ErrorBudget, LeastTolerance)));
  }
  else if (!(options.FrameTimeBudget > 0))
  {
    ladder.push_back(rung(options.Level, options.ErrorTolerance));
  }
  else if (!(options.PixelTolerance > 0))
  {
    ladder.push_back(rungOf(Accuracy::Fast, 1.0, RungPixelTolerance));
  }
  if (options.FrameTimeBudget > 0)
  {
    for (const Rung& next : { rung(Accuracy::Fast, 1.0), rung(Accuracy::Default, 1.0 / 32.0),
           rung(Accuracy::Default, DefaultAccuracy.ErrorTolerance), rung(Accuracy::Accurate, 1.0),
           rung(Accuracy::Reference, 1.0) })
    {
      const bool better = next.Tolerance > 0 && next.Tolerance < options.ErrorBudget;
      if (better || !(options.ErrorBudget > 0))
      {
        ladder.push_back(next);
      }
    }
  }
  return ladder;
}

} // namespace tetmarch

#endif
