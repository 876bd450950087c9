// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AccuracyChoice.h"

namespace tetmarch
{
namespace
{

constexpr double Rounding = 1e-4; // of the bound, as a share

bool keeps(const AccuracyWish& wish, const Rung& used, const FrameResult& frame)
{
  const bool inTime = !(wish.FrameTimeBudget > 0) || frame.Seconds <= wish.FrameTimeBudget;
  const bool exact =
    !(wish.ErrorBudget > 0) ||
    (used.Tolerance <= wish.ErrorBudget && frame.ErrorBound <= (1 + Rounding) * wish.ErrorBudget);
  return inTime && exact;
}

} // namespace

AccuracyLevel AccuracyChoice::begin(const AccuracyWish& wish)
{
  this->Wish = wish;
  this->Kept = false;
  const std::vector<Rung> ladder = ladderOf(wish);
  if (ladder != this->Ladder)
  {
    this->Ladder = ladder;
    this->Choice.restart(static_cast<int>(ladder.size()));
  }
  this->Choice.setBudget(wish.FrameTimeBudget);
  return ladder[this->Choice.level()].level();
}

void AccuracyChoice::end(const FrameResult& frame)
{
  FrameKind kind = frame.Drawn && frame.OnlyDrawn ? FrameKind::Measured : FrameKind::Disturbed;
  if (frame.Drawn)
  {
    this->Used = this->Ladder[this->Choice.level()];
    this->Kept = keeps(this->Wish, this->Used, frame);
    if (frame.Subject != this->Subject)
    {
      this->Subject = frame.Subject;
      kind = FrameKind::Changed;
    }
  }
  if (frame.IsPicture)
  {
    this->Choice.drawn(frame.Seconds, kind);
  }
}

} // namespace tetmarch
