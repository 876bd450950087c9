// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Frames with made-up costs, for the controller that chooses their level.
#ifndef tetmarch_testing_SimulatedFrames_h
#define tetmarch_testing_SimulatedFrames_h

#include "Budget/LevelController.h"

#include <random>
#include <utility>
#include <vector>

namespace tetmarch::testing
{
constexpr double Budget = 0.1;

// The first frame after a switch is disturbed: tables are made, a shader is compiled.
class Machine
{
public:
  explicit Machine(std::vector<double> costs, double budget = Budget, int first = 0)
    : Costs(std::move(costs))
    , Last(first)
  {
    this->Controller.restart(static_cast<int>(this->Costs.size()), first);
    this->Controller.setBudget(budget);
  }

  // Draws a frame; returns what it would have taken without disturbance.
  double frame()
  {
    const int level = this->Controller.level();
    const bool switched = level != this->Last;
    this->Switches += switched ? 1 : 0;
    this->Last = level;
    const double share = static_cast<double>(this->Random() % 100001) / 100000.0;
    const double seconds = this->Dearer * this->Costs[level] * (1 + this->Noise * (2 * share - 1));
    this->Controller.drawn(
      switched ? 3 * seconds : seconds, switched ? FrameKind::Disturbed : FrameKind::Measured);
    return seconds;
  }

  void frames(int count)
  {
    for (int i = 0; i < count; ++i)
    {
      this->frame();
    }
  }

  // The best level that takes at most a share of the budget; 0 if none does.
  int fitting(double share = 1) const
  {
    int level = static_cast<int>(this->Costs.size()) - 1;
    while (level > 0 && this->Dearer * this->Costs[level] > share * Budget)
    {
      --level;
    }
    return level;
  }

  LevelController Controller;
  std::vector<double> Costs;
  double Dearer = 1;
  double Noise = 0;
  int Last;
  int Switches = 0;
  std::mt19937 Random{ 7 };
};

// How many frames are simulated, for any costs.
constexpr int UntilSettled = LevelController::MostLevels * (LevelController::Patience + 3);
} // namespace tetmarch::testing

#endif
