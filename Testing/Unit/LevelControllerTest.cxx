// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Levels chosen in scenes one by one.
#include "SimulatedFrames.h"

#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch::testing;
using tetmarch::FrameKind;
using tetmarch::LevelController;

TEST(LevelController, ClimbsAtOnceWhereThereIsRoom)
{
  Machine machine({ 0.01, 0.01, 0.012, 0.02, 0.05 });
  machine.frames(8 + 1);
  EXPECT_EQ(machine.Controller.level(), 4);
  machine.frames(100);
  EXPECT_EQ(machine.Controller.level(), 4);
  EXPECT_EQ(machine.Switches, 4);
}

TEST(LevelController, NothingThatBreaksTheBudgetStays)
{
  Machine machine({ 0.02, 0.06, 0.12, 0.5 });
  machine.frames(UntilSettled);
  EXPECT_EQ(machine.Controller.level(), 1);
  machine.Dearer = 10;
  machine.frames(10);
  EXPECT_EQ(machine.Controller.level(), 0); // the cheapest, if none fits
  machine.frames(100);
  EXPECT_EQ(machine.Controller.level(), 0);
}

TEST(LevelController, ADisturbanceIsForgotten)
{
  Machine machine({ 0.02, 0.05, 0.09 });
  machine.frames(UntilSettled);
  ASSERT_EQ(machine.Controller.level(), 2);
  for (int i = 0; i < 20; ++i)
  {
    machine.Controller.drawn(1.0, i % 2 ? FrameKind::Measured : FrameKind::Disturbed);
    machine.Controller.drawn(0.09, FrameKind::Measured);
    EXPECT_EQ(machine.Controller.level(), 2);
  }
}

// What the better level takes need not keep its proportion to the others.
TEST(LevelController, WhatWasExpectedInVainIsNotTriedOverAndOver)
{
  Machine machine({ 0.02, 0.09 });
  machine.frames(UntilSettled);
  machine.Costs = { 0.08, 0.36 };
  machine.frames(50);
  EXPECT_EQ(machine.Controller.level(), 0);
  machine.Costs = { 0.02, 0.2 };
  machine.Switches = 0;
  machine.frames(500);
  EXPECT_EQ(machine.Controller.level(), 0);
  EXPECT_LE(machine.Switches, 2);
}

TEST(LevelController, WhatIsExpectedToBreakTheBudgetIsNotTried)
{
  Machine machine({ 0.02, 0.09 });
  machine.frames(UntilSettled);
  ASSERT_EQ(machine.Controller.level(), 1);
  machine.Dearer = 4;
  machine.frames(20);
  ASSERT_EQ(machine.Controller.level(), 0);
  machine.Dearer = 1.3; // clearly cheaper than when the level was left, but not enough
  machine.Switches = 0;
  machine.frames(200);
  EXPECT_EQ(machine.Controller.level(), 0);
  EXPECT_EQ(machine.Switches, 0);
  machine.Dearer = 1;
  machine.frames(20);
  EXPECT_EQ(machine.Controller.level(), 1);
}

TEST(LevelController, SomethingElseIsOnTrialAgain)
{
  Machine machine({ 0.02, 0.05, 0.09 });
  machine.frames(UntilSettled);
  ASSERT_EQ(machine.Controller.level(), 2);
  machine.Controller.drawn(1.0, FrameKind::Changed);
  EXPECT_EQ(machine.Controller.level(), 2);
  machine.Controller.drawn(0.5, FrameKind::Measured); // of that level it is the first
  EXPECT_EQ(machine.Controller.level(), 0);
  machine.Last = 0;
  machine.Costs = { 0.03, 0.06, 0.08 };
  machine.frames(UntilSettled);
  EXPECT_EQ(machine.Controller.level(), 1); // the best was left with 0.5
  machine.Controller.drawn(1.0, FrameKind::Changed);
  machine.frames(UntilSettled);
  EXPECT_EQ(machine.Controller.level(), 2);
}

TEST(LevelController, WhatChangesInEveryFrameIsNeverMeasured)
{
  Machine machine({ 0.02, 0.05, 0.09 });
  machine.frames(UntilSettled);
  for (int i = 0; i < 20; ++i)
  {
    machine.Controller.drawn(0.095, FrameKind::Changed); // it keeps the budget even so
    EXPECT_EQ(machine.Controller.level(), 2);
  }
  for (int i = 0; i < LevelController::MostUnmeasured; ++i)
  {
    EXPECT_EQ(machine.Controller.level(), 2);
    machine.Controller.drawn(0.11, FrameKind::Changed);
  }
  EXPECT_EQ(machine.Controller.level(), 0);
  machine.Last = 0;
  machine.frames(UntilSettled);
  EXPECT_EQ(machine.Controller.level(), 2);
}

TEST(LevelController, ATrialThatIsAlwaysAbortedIsGivenUp)
{
  LevelController controller;
  controller.restart(2);
  controller.setBudget(Budget);
  int tried = 0;
  for (int i = 0; i < 200; ++i)
  {
    tried += controller.level();
    controller.drawn(controller.level() == 1 ? 0.3 : 0.04,
      controller.level() == 1 ? FrameKind::Disturbed : FrameKind::Measured);
  }
  EXPECT_EQ(tried, LevelController::MostUnmeasured);
}

TEST(LevelController, FollowsTheBudget)
{
  Machine machine({ 0.02, 0.05, 0.09, 0.3 });
  machine.frames(UntilSettled);
  ASSERT_EQ(machine.Controller.level(), 2);
  machine.Controller.setBudget(0.06);
  machine.frames(2);
  EXPECT_EQ(machine.Controller.level(), 1);
  machine.Controller.setBudget(1.0);
  machine.frames(4);
  EXPECT_EQ(machine.Controller.level(), 3);
  machine.Controller.setBudget(0.001);
  machine.frames(2);
  EXPECT_EQ(machine.Controller.level(), 0);
  machine.Controller.setBudget(std::numeric_limits<double>::max());
  machine.frames(4);
  EXPECT_EQ(machine.Controller.level(), 3);
}

TEST(LevelController, ClocksMayStandStill)
{
  Machine machine({ 0.0, 0.0, 0.0 });
  machine.frames(20);
  EXPECT_EQ(machine.Controller.level(), 2);
}

TEST(LevelController, OneLevelIsKept)
{
  for (const double budget : { 0.0, Budget })
  {
    Machine machine({ 1.0 }, budget);
    machine.frames(50);
    EXPECT_EQ(machine.Controller.level(), 0);
  }
}
} // namespace
