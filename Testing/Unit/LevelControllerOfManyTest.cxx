// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Levels chosen for many random ladders of costs.
#include "SimulatedFrames.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch::testing;
using tetmarch::LevelController;

// From one level to the next at most so many times as dear.
constexpr double MostGrowth = 3;

std::vector<double> randomCosts(std::mt19937& random)
{
  const auto share = [&] { return static_cast<double>(random() % 1000) / 999.0; };
  std::vector<double> costs{ Budget * (0.02 + 1.2 * share() * share()) };
  const std::size_t levels = 1 + random() % LevelController::MostLevels;
  while (costs.size() < levels)
  {
    const double growth = random() % 3 == 0 ? 1.05 : 1 + (MostGrowth - 1) * share();
    costs.push_back(costs.back() * growth);
  }
  return costs;
}

TEST(LevelControllerOfMany, ReachesTheBestThatFits)
{
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i)
  {
    Machine machine(randomCosts(random));
    machine.frames(UntilSettled);
    EXPECT_EQ(machine.Controller.level(), machine.fitting());
    machine.Switches = 0;
    machine.frames(100);
    EXPECT_EQ(machine.Switches, 0);
  }
}

TEST(LevelControllerOfMany, TrialsAreBoundedInTimeAndNumber)
{
  std::mt19937 random(2);
  for (int i = 0; i < 3000; ++i)
  {
    Machine machine(randomCosts(random));
    const double cheapest = machine.Costs[0];
    int over = 0;
    for (int frame = 0; frame < 300; ++frame)
    {
      const bool early = frame < LevelController::Patience;
      const int level = machine.Controller.level();
      const double seconds = machine.frame();
      over += level > 0 && seconds > Budget ? 1 : 0;
      const double most = (early ? 0.5 : 1.0) * MostGrowth * Budget;
      EXPECT_LE(seconds, std::max(cheapest, most * (1 + 1e-12)));
    }
    EXPECT_LE(over, 2); // one level, in one disturbed frame and one measured
  }
}

TEST(LevelControllerOfMany, NoiseDoesNotMakeItOscillate)
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
    EXPECT_GE(machine.Controller.level(), machine.fitting(1 / 1.2 / 1.2));
    EXPECT_LE(machine.Controller.level(), machine.fitting(1.1));
    machine.Switches = 0;
    machine.frames(1000);
    EXPECT_LE(machine.Switches, 4);
    switches += machine.Switches;
  }
  EXPECT_LE(switches, 50); // in half a million frames
  std::cout << "[ MEASURED ] " << switches << " switches in 500,000 frames\n";
}

TEST(LevelControllerOfMany, FollowsTheCameraThereAndBack)
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
        EXPECT_LE(machine.Controller.level(), machine.fitting(1 + noise));
        machine.frames(80);
        EXPECT_GE(machine.Controller.level(), machine.fitting(share));
        machine.Dearer = 1;
        machine.frames(40);
        EXPECT_GE(machine.Controller.level(), machine.fitting(share));
        EXPECT_LE(machine.Controller.level(), machine.fitting(1 + noise));
        machine.frames(60);
      }
    }
  }
}

// Level 0 need not be cheaper than the first one: only where that breaks the budget, and this one
// is cheaper, is it used.
TEST(LevelControllerOfMany, ALevelBelowTheFirstIsUsedWhereItHelps)
{
  std::mt19937 random(5);
  for (const double noise : { 0.0, 0.2 })
  {
    int switches = 0;
    for (int i = 0; i < 1000; ++i)
    {
      std::vector<double> costs = randomCosts(random);
      const double share = 0.1 + 1.4 * static_cast<double>(random() % 1000) / 999.0;
      costs.insert(costs.begin(), share * costs[0]);
      costs.resize(std::min<std::size_t>(costs.size(), LevelController::MostLevels));
      Machine machine(costs, Budget, 1);
      machine.Random.seed(random());
      machine.Noise = noise;
      machine.frames(300);
      const int fits = machine.fitting();
      if (noise == 0.0)
      {
        EXPECT_EQ(machine.Controller.level(), fits > 0 ? fits : (share < 1 ? 0 : 1)) << share;
      }
      machine.Switches = 0;
      machine.frames(1000);
      EXPECT_LE(machine.Switches, noise > 0 ? 6 : 0);
      switches += machine.Switches;
    }
    EXPECT_LE(switches, 100); // in a million frames
  }
}

TEST(LevelControllerOfMany, FollowsASlowZoom)
{
  Machine machine({ 0.010, 0.011, 0.016, 0.05 });
  machine.frames(UntilSettled);
  EXPECT_EQ(machine.Controller.level(), 3);
  int over = 0;
  for (int i = 0; i < 100; ++i)
  {
    machine.Dearer *= 1.02;
    over += machine.frame() > Budget && machine.Controller.level() > 0 ? 1 : 0;
  }
  EXPECT_EQ(machine.Controller.level(), machine.fitting());
  EXPECT_LE(over, 25);
  for (int i = 0; i < 100; ++i)
  {
    machine.Dearer /= 1.02;
    machine.frame();
  }
  EXPECT_EQ(machine.Controller.level(), 3);
}
} // namespace
