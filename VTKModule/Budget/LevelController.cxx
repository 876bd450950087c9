// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Budget/LevelController.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

constexpr double LeastSeconds = 1e-9; // the clock's resolution may be coarse

// Shares of the budget: maximum time of the current level if the next one is tried at once, and
// maximum expected time of a level that is used without a trial.
constexpr double TrialShare = 0.5;
constexpr double Aim = 0.95;

// Share of the time that was expected when the level was left: noise of 20 % does not reach it.
constexpr double ClearlyCheaper = 0.75;

// Two measurements of the same thing differ by a smaller factor, with noise of 20 % to either side.
constexpr double MostNoise = 1.6;

constexpr int MostAveraged = 8;
constexpr int LeastAveraged = 4; // before small changes are also applied to other levels

bool isOff(double seconds, double expected)
{
  return seconds > MostNoise * expected || expected > MostNoise * seconds;
}

} // namespace

void LevelController::restart(int levels, int first)
{
  this->Levels = std::clamp(levels, 1, MostLevels);
  this->First = std::clamp(first, 0, this->Levels - 1);
  this->Past.fill({});
  this->Unmeasured = 0;
  this->use(this->First);
}

void LevelController::setBudget(double seconds)
{
  if (seconds != this->Budget)
  {
    this->Budget = seconds;
    for (Memory& past : this->Past)
    {
      past.WhenLeft = 0;
    }
  }
}

void LevelController::drawn(double seconds, FrameKind kind)
{
  if (kind == FrameKind::Measured)
  {
    this->Unmeasured = 0;
    this->measure(std::max(seconds, LeastSeconds));
    this->choose();
    return;
  }
  if (kind == FrameKind::Changed)
  {
    this->Past.fill({});
    this->use(this->Current);
  }
  const bool keeps = this->isKnown(this->Current) || seconds <= this->Budget;
  this->Unmeasured = keeps ? 0 : this->Unmeasured + 1;
  if (this->Unmeasured >= MostUnmeasured)
  {
    if (kind == FrameKind::Disturbed) // otherwise it would be tried again at once
    {
      this->Past[this->Current].Seconds = seconds;
    }
    this->leave();
    this->Unmeasured = 0;
  }
}

void LevelController::measure(double seconds)
{
  double& expected = this->Past[this->Current].Seconds;
  const double before = expected;
  const bool off = this->isKnown(this->Current) && isOff(seconds, before);
  const bool again = this->Outlier > 0 && (this->Outlier > before) == (seconds > before);
  if (!this->isKnown(this->Current) || (off && !this->Arrived))
  {
    expected = seconds; // the expectation was wrong for this level only
    this->Count = 1;
  }
  else if (off && again)
  {
    expected =
      seconds > before ? std::min(seconds, this->Outlier) : std::max(seconds, this->Outlier);
    this->Count = 2;
    this->scaleOthers(expected / before);
  }
  else if (!off)
  {
    this->Count = std::min(this->Count + 1, MostAveraged);
    expected += (seconds - before) / this->Count;
    if (this->Count > LeastAveraged)
    {
      this->scaleOthers(expected / before);
    }
  }
  this->Outlier = off && !again && this->Arrived ? seconds : 0;
  this->Arrived = true;
}

void LevelController::scaleOthers(double factor)
{
  for (int i = 0; i < this->Levels; ++i)
  {
    this->Past[i].Seconds *= i == this->Current ? 1.0 : factor;
  }
}

void LevelController::choose()
{
  if (this->Past[this->Current].Seconds > this->Budget)
  {
    this->leave();
  }
  else if (const int next = this->best(); next != this->Current)
  {
    this->use(next);
  }
}

bool LevelController::mayFit(int level) const
{
  const Memory& past = this->Past[level];
  return this->isKnown(level) && past.Seconds <= Aim * this->Budget &&
         !(past.WhenLeft > 0 && past.Seconds > ClearlyCheaper * past.WhenLeft);
}

int LevelController::best() const
{
  for (int i = this->Levels - 1; i > this->Current; --i)
  {
    if (this->mayFit(i))
    {
      return i;
    }
  }
  const bool unknown = this->Current + 1 < this->Levels && !this->isKnown(this->Current + 1);
  const bool cheap = this->Past[this->Current].Seconds <= TrialShare * this->Budget;
  return unknown && (cheap || this->Count >= Patience) ? this->Current + 1 : this->Current;
}

// If no level is known to keep the budget: level 0, or the first level, which is better, if level 0
// is hardly cheaper. Neither is left for the other over and over because of noise.
int LevelController::cheapest() const
{
  const double least = this->Past[0].Seconds;
  const double most = (this->Current == 0 ? 1.0 : ClearlyCheaper) * this->Past[this->First].Seconds;
  return !this->isKnown(0) || least <= this->Budget || least < most ? 0 : this->First;
}

void LevelController::leave()
{
  int next = this->Current - 1;
  while (next > 0 && !(this->isKnown(next) && this->Past[next].Seconds <= this->Budget))
  {
    --next;
  }
  next = next > 0 ? next : this->cheapest();
  for (int i = next + 1; i <= this->Current; ++i)
  {
    this->Past[i].WhenLeft = this->Past[i].Seconds;
  }
  if (next != this->Current)
  {
    this->use(next);
  }
}

void LevelController::use(int level)
{
  this->Current = level;
  this->Past[level].WhenLeft = 0;
  this->Count = this->isKnown(level) ? 1 : 0;
  this->Arrived = false;
  this->Outlier = 0;
}

} // namespace tetmarch
