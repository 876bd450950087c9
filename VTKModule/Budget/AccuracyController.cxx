// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Budget/AccuracyController.h"

namespace tetmarch
{
namespace
{

constexpr double Rounding = 1e-4; // share of the bound

bool keeps(const AccuracyOptions& options, const Rung& used, const FrameResult& frame)
{
  const bool inTime = !(options.FrameTimeBudget > 0) || frame.Seconds <= options.FrameTimeBudget;
  const bool exact =
    !(options.ErrorBudget > 0) ||
    (used.Tolerance <= options.ErrorBudget && !(used.PixelTolerance > 0) && // that is an estimate
      frame.ErrorBound <= (1 + Rounding) * options.ErrorBudget);
  return inTime && exact;
}

} // namespace

Rung AccuracyController::begin(const AccuracyOptions& options)
{
  this->Options = options;
  this->Kept = false;
  const std::vector<Rung> ladder = ladderOf(options);
  if (ladder != this->Ladder)
  {
    this->Ladder = ladder;
    this->Choice.restart(static_cast<int>(ladder.size()), firstOf(ladder));
  }
  this->Choice.setBudget(options.FrameTimeBudget);
  return ladder[this->Choice.level()];
}

void AccuracyController::end(const FrameResult& frame)
{
  FrameKind kind = frame.Drawn && frame.OnlyDrawn ? FrameKind::Measured : FrameKind::Disturbed;
  if (frame.Drawn)
  {
    this->Used = this->Ladder[this->Choice.level()];
    this->Used.PixelTolerance = frame.PixelTolerance;
    this->Kept = keeps(this->Options, this->Used, frame);
    if (frame.ContentVersion != this->ContentVersion)
    {
      this->ContentVersion = frame.ContentVersion;
      kind = FrameKind::Changed;
    }
  }
  if (frame.IsPicture)
  {
    this->Choice.drawn(frame.Seconds, kind);
  }
}

} // namespace tetmarch
