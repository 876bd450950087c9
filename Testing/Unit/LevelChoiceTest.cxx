// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Levels chosen for frames whose cost is made up.
#include "Scene/LevelChoice.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

namespace
{
using tetmarch::FrameKind;
using tetmarch::LevelChoice;

constexpr double Budget = 0.1;

// The first frame after a switch is disturbed: tables are made, a shader is compiled.
class Machine
{
public:
  explicit Machine(std::vector<double> costs, double budget = Budget)
    : Costs(std::move(costs))
  {
    this->Choice.restart(static_cast<int>(this->Costs.size()));
    this->Choice.setBudget(budget);
  }

  // Draws a frame; returns what it would have taken without disturbance.
  double frame()
  {
    const int level = this->Choice.level();
    const bool switched = level != this->Last;
    this->Switches += switched ? 1 : 0;
    this->Last = level;
    const double share = static_cast<double>(this->Random() % 100001) / 100000.0;
    const double seconds = this->Dearer * this->Costs[level] * (1 + this->Noise * (2 * share - 1));
    this->Choice.drawn(
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

  LevelChoice Choice;
  std::vector<double> Costs;
  double Dearer = 1;
  double Noise = 0;
  int Last = 0;
  int Switches = 0;
  std::mt19937 Random{ 7 };
};

// From one level to the next at most so many times as dear.
constexpr double MostGrowth = 3;

std::vector<double> randomCosts(std::mt19937& random)
{
  const auto share = [&] { return static_cast<double>(random() % 1000) / 999.0; };
  std::vector<double> costs{ Budget * (0.02 + 1.2 * share() * share()) };
  const std::size_t levels = 1 + random() % LevelChoice::MostLevels;
  while (costs.size() < levels)
  {
    const double growth = random() % 3 == 0 ? 1.05 : 1 + (MostGrowth - 1) * share();
    costs.push_back(costs.back() * growth);
  }
  return costs;
}

constexpr int UntilSettled = LevelChoice::MostLevels * (LevelChoice::Patience + 3);

TEST(LevelChoice, ReachesTheBestThatFits)
{
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i)
  {
    Machine machine(randomCosts(random));
    machine.frames(UntilSettled);
    EXPECT_EQ(machine.Choice.level(), machine.fitting());
    machine.Switches = 0;
    machine.frames(100);
    EXPECT_EQ(machine.Switches, 0);
  }
}

TEST(LevelChoice, TrialsAreBoundedInTimeAndNumber)
{
  std::mt19937 random(2);
  for (int i = 0; i < 3000; ++i)
  {
    Machine machine(randomCosts(random));
    const double cheapest = machine.Costs[0];
    int over = 0;
    for (int frame = 0; frame < 300; ++frame)
    {
      const bool early = frame < LevelChoice::Patience;
      const int level = machine.Choice.level();
      const double seconds = machine.frame();
      over += level > 0 && seconds > Budget ? 1 : 0;
      const double most = (early ? 0.5 : 1.0) * MostGrowth * Budget;
      EXPECT_LE(seconds, std::max(cheapest, most * (1 + 1e-12)));
    }
    EXPECT_LE(over, 2); // one level, in one disturbed frame and one measured
  }
}

TEST(LevelChoice, ClimbsAtOnceWhereThereIsRoom)
{
  Machine machine({ 0.01, 0.01, 0.012, 0.02, 0.05 });
  machine.frames(8 + 1);
  EXPECT_EQ(machine.Choice.level(), 4);
  machine.frames(100);
  EXPECT_EQ(machine.Choice.level(), 4);
  EXPECT_EQ(machine.Switches, 4);
}

TEST(LevelChoice, NothingThatBreaksTheBudgetStays)
{
  Machine machine({ 0.02, 0.06, 0.12, 0.5 });
  machine.frames(UntilSettled);
  EXPECT_EQ(machine.Choice.level(), 1);
  machine.Dearer = 10;
  machine.frames(10);
  EXPECT_EQ(machine.Choice.level(), 0); // the cheapest, if none fits
  machine.frames(100);
  EXPECT_EQ(machine.Choice.level(), 0);
}

TEST(LevelChoice, NoiseDoesNotMakeItOscillate)
{
  std::mt19937 random(3);
  int switches = 0;
  for (int i = 0; i < 500; ++i)
  {
    Machine machine(randomCosts(random));
    machine.Random.seed(random());
    machine.Noise = 0.2;
    machine.frames(200);
    // What fits in spite of noise is reached; what breaks the budget in spite of it is not kept.
    EXPECT_GE(machine.Choice.level(), machine.fitting(1 / 1.2 / 1.2));
    EXPECT_LE(machine.Choice.level(), machine.fitting(1.1));
    machine.Switches = 0;
    machine.frames(1000);
    EXPECT_LE(machine.Switches, 4);
    switches += machine.Switches;
  }
  EXPECT_LE(switches, 50); // in half a million frames
  std::cout << "[ MEASURED ] " << switches << " switches in 500,000 frames\n";
}

TEST(LevelChoice, FollowsTheCameraThereAndBack)
{
  std::mt19937 random(4);
  for (const double noise : { 0.0, 0.2 })
  {
    for (int i = 0; i < 500; ++i)
    {
      Machine machine(randomCosts(random));
      machine.Random.seed(random());
      machine.Noise = noise;
      const double share = noise > 0 ? 1 / 1.2 / 1.2 : 0.94;
      machine.frames(200);
      for (int move = 0; move < 3; ++move)
      {
        machine.Dearer = 4;
        machine.frames(20);
        EXPECT_LE(machine.Choice.level(), machine.fitting(1 + noise));
        machine.frames(80);
        EXPECT_GE(machine.Choice.level(), machine.fitting(share));
        machine.Dearer = 1;
        machine.frames(40);
        EXPECT_GE(machine.Choice.level(), machine.fitting(share));
        EXPECT_LE(machine.Choice.level(), machine.fitting(1 + noise));
        machine.frames(60);
      }
    }
  }
}

TEST(LevelChoice, FollowsASlowZoom)
{
  Machine machine({ 0.010, 0.011, 0.016, 0.05 });
  machine.frames(UntilSettled);
  EXPECT_EQ(machine.Choice.level(), 3);
  int over = 0;
  for (int i = 0; i < 100; ++i)
  {
    machine.Dearer *= 1.02;
    over += machine.frame() > Budget && machine.Choice.level() > 0 ? 1 : 0;
  }
  EXPECT_EQ(machine.Choice.level(), machine.fitting());
  EXPECT_LE(over, 25);
  for (int i = 0; i < 100; ++i)
  {
    machine.Dearer /= 1.02;
    machine.frame();
  }
  EXPECT_EQ(machine.Choice.level(), 3);
}

TEST(LevelChoice, ADisturbanceIsForgotten)
{
  Machine machine({ 0.02, 0.05, 0.09 });
  machine.frames(UntilSettled);
  ASSERT_EQ(machine.Choice.level(), 2);
  for (int i = 0; i < 20; ++i)
  {
    machine.Choice.drawn(1.0, i % 2 ? FrameKind::Measured : FrameKind::Disturbed);
    machine.Choice.drawn(0.09, FrameKind::Measured);
    EXPECT_EQ(machine.Choice.level(), 2);
  }
}

// What the better level takes need not keep its proportion to the others.
TEST(LevelChoice, WhatWasExpectedInVainIsNotTriedOverAndOver)
{
  Machine machine({ 0.02, 0.09 });
  machine.frames(UntilSettled);
  machine.Costs = { 0.08, 0.36 };
  machine.frames(50);
  EXPECT_EQ(machine.Choice.level(), 0);
  machine.Costs = { 0.02, 0.2 };
  machine.Switches = 0;
  machine.frames(500);
  EXPECT_EQ(machine.Choice.level(), 0);
  EXPECT_LE(machine.Switches, 2);
}

TEST(LevelChoice, WhatIsExpectedToBreakTheBudgetIsNotTried)
{
  Machine machine({ 0.02, 0.09 });
  machine.frames(UntilSettled);
  ASSERT_EQ(machine.Choice.level(), 1);
  machine.Dearer = 4;
  machine.frames(20);
  ASSERT_EQ(machine.Choice.level(), 0);
  machine.Dearer = 1.3; // clearly cheaper than when the level was left, but not enough
  machine.Switches = 0;
  machine.frames(200);
  EXPECT_EQ(machine.Choice.level(), 0);
  EXPECT_EQ(machine.Switches, 0);
  machine.Dearer = 1;
  machine.frames(20);
  EXPECT_EQ(machine.Choice.level(), 1);
}

TEST(LevelChoice, SomethingElseIsOnTrialAgain)
{
  Machine machine({ 0.02, 0.05, 0.09 });
  machine.frames(UntilSettled);
  ASSERT_EQ(machine.Choice.level(), 2);
  machine.Choice.drawn(1.0, FrameKind::Changed);
  EXPECT_EQ(machine.Choice.level(), 2);
  machine.Choice.drawn(0.5, FrameKind::Measured); // of that level it is the first
  EXPECT_EQ(machine.Choice.level(), 0);
  machine.Last = 0;
  machine.Costs = { 0.03, 0.06, 0.08 };
  machine.frames(UntilSettled);
  EXPECT_EQ(machine.Choice.level(), 1); // the best was left with 0.5
  machine.Choice.drawn(1.0, FrameKind::Changed);
  machine.frames(UntilSettled);
  EXPECT_EQ(machine.Choice.level(), 2);
}

TEST(LevelChoice, WhatChangesInEveryFrameIsNeverMeasured)
{
  Machine machine({ 0.02, 0.05, 0.09 });
  machine.frames(UntilSettled);
  for (int i = 0; i < 20; ++i)
  {
    machine.Choice.drawn(0.095, FrameKind::Changed); // it keeps the budget even so
    EXPECT_EQ(machine.Choice.level(), 2);
  }
  for (int i = 0; i < LevelChoice::MostUnmeasured; ++i)
  {
    EXPECT_EQ(machine.Choice.level(), 2);
    machine.Choice.drawn(0.11, FrameKind::Changed);
  }
  EXPECT_EQ(machine.Choice.level(), 0);
  machine.Last = 0;
  machine.frames(UntilSettled);
  EXPECT_EQ(machine.Choice.level(), 2);
}

TEST(LevelChoice, ATrialThatIsAlwaysAbortedIsGivenUp)
{
  LevelChoice choice;
  choice.restart(2);
  choice.setBudget(Budget);
  int tried = 0;
  for (int i = 0; i < 200; ++i)
  {
    tried += choice.level();
    choice.drawn(choice.level() == 1 ? 0.3 : 0.04,
      choice.level() == 1 ? FrameKind::Disturbed : FrameKind::Measured);
  }
  EXPECT_EQ(tried, LevelChoice::MostUnmeasured);
}

TEST(LevelChoice, FollowsTheBudget)
{
  Machine machine({ 0.02, 0.05, 0.09, 0.3 });
  machine.frames(UntilSettled);
  ASSERT_EQ(machine.Choice.level(), 2);
  machine.Choice.setBudget(0.06);
  machine.frames(2);
  EXPECT_EQ(machine.Choice.level(), 1);
  machine.Choice.setBudget(1.0);
  machine.frames(4);
  EXPECT_EQ(machine.Choice.level(), 3);
  machine.Choice.setBudget(0.001);
  machine.frames(2);
  EXPECT_EQ(machine.Choice.level(), 0);
  machine.Choice.setBudget(std::numeric_limits<double>::max());
  machine.frames(4);
  EXPECT_EQ(machine.Choice.level(), 3);
}

TEST(LevelChoice, ClocksMayStandStill)
{
  Machine machine({ 0.0, 0.0, 0.0 });
  machine.frames(20);
  EXPECT_EQ(machine.Choice.level(), 2);
}

TEST(LevelChoice, OneLevelIsNoChoice)
{
  for (const double budget : { 0.0, Budget })
  {
    Machine machine({ 1.0 }, budget);
    machine.frames(50);
    EXPECT_EQ(machine.Choice.level(), 0);
  }
}
} // namespace
