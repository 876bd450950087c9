// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which level the controller takes for budgets of time and error, and whether they were kept.
#include "Budget/AccuracyController.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;

FrameResult drawn(double seconds) { return { true, true, true, seconds, 0, { 1 } }; }

AccuracyOptions budgets(double frameTime, double error)
{
  return { Accuracy::Accurate, 0.5, frameTime, error };
}

TEST(AccuracyLadder, WithoutBudgetsItIsWhatIsSet)
{
  for (const Accuracy level :
    { Accuracy::Fast, Accuracy::Default, Accuracy::Accurate, Accuracy::Reference })
  {
    for (const double tolerance : { 1.0, 1.0 / 255.0, 1e-6 })
    {
      const std::vector<Rung> ladder = ladderOf({ level, tolerance });
      ASSERT_EQ(ladder.size(), 1u);
      const AccuracyLevel expected = levelOf(level, tolerance);
      EXPECT_EQ(ladder[0].Level, level);
      EXPECT_EQ(ladder[0].Tolerance, expected.Adaptive ? expected.ErrorTolerance : 0.0);
      const AccuracyLevel made = ladder[0].level();
      EXPECT_EQ(made.Adaptive, expected.Adaptive);
      EXPECT_EQ(made.ErrorTolerance, expected.ErrorTolerance);
      EXPECT_EQ(made.MostTrials, expected.MostTrials);
      EXPECT_EQ(made.LeastTableEntries, expected.LeastTableEntries);
    }
  }
}

TEST(AccuracyLadder, OfTimeHasAllLevelsAndOneOfInterpolatedPixels)
{
  std::vector<Rung> expected{ { Accuracy::Fast, 0 }, { Accuracy::Default, 1.0 / 32.0 },
    { Accuracy::Default, 1.0 / 255.0 }, { Accuracy::Accurate, 1.0 / 4096.0 },
    { Accuracy::Reference, 1e-5 } };
  expected.insert(expected.begin(), { Accuracy::Fast, 0, 4.0 / 255.0 });
  EXPECT_TRUE(ladderOf(budgets(0.1, 0)) == expected);
  EXPECT_EQ(firstOf(expected), 1);
}

// Whatever the budget.
TEST(AccuracyLadder, APixelToleranceThatIsSetStays)
{
  for (const double time : { 0.0, 0.1 })
  {
    for (const double error : { 0.0, 0.01 })
    {
      const std::vector<Rung> without = ladderOf(budgets(time, error));
      AccuracyOptions options = budgets(time, error);
      options.PixelTolerance = 0.001;
      const std::vector<Rung> ladder = ladderOf(options);
      const auto interpolates = [](const Rung& rung) { return rung.PixelTolerance > 0; };
      EXPECT_EQ(std::count_if(without.begin(), without.end(), interpolates),
        time > 0 && error == 0.0 ? 1 : 0);
      EXPECT_EQ(firstOf(ladder), 0);
      EXPECT_EQ(ladder.size() + firstOf(without), without.size());
      for (const Rung& rung : ladder)
      {
        EXPECT_EQ(rung.PixelTolerance, 0.001);
      }
    }
  }
}

TEST(AccuracyLadder, OfAnErrorIsTheToleranceAndWhatIsBetter)
{
  EXPECT_TRUE(ladderOf(budgets(0, 0.01)) == std::vector<Rung>({ { Accuracy::Default, 0.01 } }));
  EXPECT_TRUE(ladderOf(budgets(0, 1e-9)) == std::vector<Rung>({ { Accuracy::Default, 1e-6 } }));
  for (const double error : { 1.0, 1.0 / 32.0, 0.01, 1.0 / 255.0, 1e-4, 1e-5, 1e-6 })
  {
    const std::vector<Rung> ladder = ladderOf(budgets(0.1, error));
    EXPECT_EQ(ladder[0].Level, Accuracy::Default);
    EXPECT_EQ(ladder[0].Tolerance, error);
    for (std::size_t i = 1; i < ladder.size(); ++i)
    {
      EXPECT_LT(ladder[i].Tolerance, ladder[i - 1].Tolerance);
      EXPECT_GT(ladder[i].Tolerance, 0.0);
    }
    EXPECT_LE(ladder.size(), std::size_t(LevelController::MostLevels));
    EXPECT_EQ(ladder.back().Tolerance, std::min(error, 1e-5));
  }
}

TEST(AccuracyController, SaysWhatWasUsedAndKept)
{
  AccuracyController controller;
  EXPECT_TRUE(controller.used() == Rung());
  EXPECT_FALSE(controller.isKept()); // nothing was drawn
  controller.begin({ Accuracy::Reference, 1.0 });
  controller.end(drawn(100));
  EXPECT_TRUE(controller.used() == (Rung{ Accuracy::Reference, 1e-5 }));
  EXPECT_TRUE(controller.isKept());

  EXPECT_TRUE(controller.begin(budgets(0.1, 0)) == (Rung{ Accuracy::Fast, 0 }));
  controller.end(drawn(0.05));
  EXPECT_EQ(controller.used().Level, Accuracy::Fast);
  EXPECT_TRUE(controller.isKept());
  controller.begin(budgets(0.1, 0));
  controller.end(drawn(0.11));
  EXPECT_FALSE(controller.isKept());

  EXPECT_EQ(controller.begin(budgets(0, 0.01)).Tolerance, 0.01);
  controller.end(drawn(100));
  EXPECT_TRUE(controller.used() == (Rung{ Accuracy::Default, 0.01 }));
  EXPECT_TRUE(controller.isKept());
  controller.begin(budgets(0, 1e-9)); // nothing keeps that
  controller.end(drawn(0));
  EXPECT_FALSE(controller.isKept());
}

TEST(AccuracyController, ABoundThatWasMeasuredCounts)
{
  AccuracyController controller;
  FrameResult frame = drawn(0.01);
  for (const double bound : { 0.0, 0.0099, 0.0101 })
  {
    frame.ErrorBound = bound;
    controller.begin(budgets(0, 0.01));
    controller.end(frame);
    EXPECT_EQ(controller.isKept(), bound <= 0.01);
  }
}

// It is an estimate. Where a ray was traced for each pixel all the same, it doesn't matter.
TEST(AccuracyController, InterpolatedPixelsKeepNoErrorBudget)
{
  AccuracyController controller;
  AccuracyOptions options = budgets(0, 0.01);
  options.PixelTolerance = 0.005;
  for (const double drawnWith : { 0.005, 0.0 })
  {
    FrameResult frame = drawn(0.01);
    frame.PixelTolerance = drawnWith;
    EXPECT_EQ(controller.begin(options).PixelTolerance, 0.005);
    controller.end(frame);
    EXPECT_EQ(controller.isKept(), drawnWith == 0.0);
    EXPECT_EQ(controller.used().PixelTolerance, drawnWith);
  }
}

TEST(AccuracyController, PixelsAreInterpolatedWhereTheFastestLevelTakesTooLong)
{
  AccuracyController controller;
  const auto draw = [&](double ofFast)
  {
    const Rung rung = controller.begin(budgets(0.1, 0));
    FrameResult frame = drawn(rung.PixelTolerance > 0 ? ofFast / 3 : ofFast);
    frame.PixelTolerance = rung.PixelTolerance;
    controller.end(frame);
    return rung;
  };
  for (int i = 0; i < 50; ++i) // the first frame of something else isn't measured
  {
    EXPECT_TRUE(draw(0.2) == (Rung{ Accuracy::Fast, 0, i < 2 ? 0.0 : 4.0 / 255.0 }));
    EXPECT_EQ(controller.isKept(), i >= 2);
  }
  for (int i = 0; i < 50; ++i)
  {
    draw(0.02);
  }
  EXPECT_TRUE(draw(0.02) == (Rung{ Accuracy::Reference, 1e-5 }));
}

TEST(AccuracyController, TheErrorComesBeforeTheTime)
{
  AccuracyController controller;
  for (int i = 0; i < 50; ++i)
  {
    EXPECT_EQ(controller.begin(budgets(0.1, 0.01)).Tolerance, 0.01);
    controller.end(drawn(0.2));
    EXPECT_FALSE(controller.isKept());
  }
  for (int i = 0; i < 50; ++i)
  {
    EXPECT_LE(controller.begin(budgets(0.1, 0.02)).Tolerance, 0.02);
    controller.end(drawn(0.02));
    EXPECT_TRUE(controller.isKept());
  }
  EXPECT_EQ(controller.used().Level, Accuracy::Reference);
}

TEST(AccuracyController, FramesThatAreNotDrawnKeepNothing)
{
  AccuracyController controller;
  controller.begin(budgets(0.1, 0));
  controller.end(drawn(0.01));
  controller.begin(budgets(0.1, 0));
  controller.end({ false, true, true, 0.01, 0, {} });
  EXPECT_FALSE(controller.isKept());
  EXPECT_EQ(controller.used().Level, Accuracy::Fast);
}

// Frames are cheap enough for the best level, but none of them tells what drawing costs: each is of
// another scene, or has made something beside drawing.
TEST(AccuracyController, OnlyFramesOfTheSameAreMeasured)
{
  for (const bool onlyDrawn : { true, false })
  {
    AccuracyController controller;
    for (std::uintptr_t i = 0; i < 100; ++i)
    {
      controller.begin(budgets(0.1, 0));
      controller.end({ true, true, onlyDrawn, 0.001, 0, { onlyDrawn ? i : 0 } });
      EXPECT_EQ(controller.used().Level, Accuracy::Fast);
    }
  }
}

// A view may take much longer than a picture, or less.
TEST(AccuracyController, ViewsOfErrorOrCostChangeNothing)
{
  AccuracyController controller;
  for (int i = 0; i < 100; ++i)
  {
    controller.begin(budgets(0.1, 0));
    controller.end(drawn(0.01));
  }
  EXPECT_EQ(controller.used().Level, Accuracy::Reference);
  for (const double seconds : { 0.5, 0.001 })
  {
    for (int i = 0; i < 20; ++i)
    {
      controller.begin(budgets(0.1, 0));
      FrameResult view = drawn(seconds);
      view.IsPicture = false;
      controller.end(view);
      EXPECT_EQ(controller.used().Level, Accuracy::Reference);
      EXPECT_EQ(controller.isKept(), seconds <= 0.1);
    }
  }
}
} // namespace
