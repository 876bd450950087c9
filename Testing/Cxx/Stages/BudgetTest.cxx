// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The level that the mapper chooses for a frame time or an error, and what it reports.
#include "ErrorWatch.h"
#include "LitScene.h"

#include "vtkTetMarchFrameStatistics.h"

#include <gtest/gtest.h>
#include <iostream>
#include <set>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;

constexpr double Huge = 1e6; // seconds, for any frame
constexpr double Tiny = 1e-6;

// Each level takes a frame for its tables or its shader and one to be measured.
constexpr int UntilBest = 2 * 5 + 1;

class Budget : public testing::Test
{
protected:
  Budget() { this->mapper()->CollectDiagnosticsOff(); }

  Mapper* mapper() { return this->Shown.Mapper; }
  void frames(int count)
  {
    for (int i = 0; i < count; ++i)
    {
      this->Shown.Window->Render();
    }
  }
  void expectUsed(int level, double tolerance)
  {
    EXPECT_EQ(this->mapper()->GetUsedAccuracyLevel(), level);
    EXPECT_EQ(this->mapper()->GetUsedErrorTolerance(), tolerance);
  }
  void expectPrepared(int times)
  {
    EXPECT_EQ(this->mapper()->GetMeshBuilds(), times);
    EXPECT_EQ(this->mapper()->GetScalarsBuilds(), times);
  }

  Scene Shown{ jitteredLattice(8, 0.15, 5, sineField()) };
};

TEST_F(Budget, IsClamped)
{
  EXPECT_EQ(this->mapper()->GetFrameTimeBudget(), 0.0);
  EXPECT_EQ(this->mapper()->GetErrorBudget(), 0.0);
  this->mapper()->SetFrameTimeBudget(-1.0);
  this->mapper()->SetErrorBudget(-1.0);
  EXPECT_EQ(this->mapper()->GetFrameTimeBudget(), 0.0);
  EXPECT_EQ(this->mapper()->GetErrorBudget(), 0.0);
  this->mapper()->SetErrorBudget(7.0);
  EXPECT_EQ(this->mapper()->GetErrorBudget(), 1.0);
}

TEST_F(Budget, WithoutOneTheLevelIsTheOneThatIsSet)
{
  EXPECT_FALSE(this->mapper()->IsBudgetKept()); // nothing was drawn
  this->expectUsed(Mapper::DEFAULT, 1.0 / 255.0);
  this->mapper()->SetErrorTolerance(0.125);
  this->frames(1);
  this->expectUsed(Mapper::DEFAULT, 0.125);
  EXPECT_TRUE(this->mapper()->IsBudgetKept());
  this->mapper()->SetAccuracyLevelToFast();
  this->frames(1);
  this->expectUsed(Mapper::FAST, 0.0);
  this->mapper()->SetAccuracyLevelToAccurate();
  this->frames(1);
  this->expectUsed(Mapper::ACCURATE, 1.0 / 4096.0);
}

TEST_F(Budget, OfMuchTimeEndsAtTheBest)
{
  this->mapper()->SetFrameTimeBudget(Huge);
  int level = Mapper::FAST;
  for (int i = 0; i < UntilBest; ++i)
  {
    this->frames(1);
    EXPECT_GE(this->mapper()->GetUsedAccuracyLevel(), level);
    level = this->mapper()->GetUsedAccuracyLevel();
    EXPECT_EQ(level == Mapper::FAST, i < 2);
    EXPECT_TRUE(this->mapper()->IsBudgetKept());
  }
  this->expectUsed(Mapper::REFERENCE, 1e-5);
  this->expectPrepared(1);
  const vtkTypeInt64 tables = this->mapper()->GetTablesBuilds();
  this->Shown.camera()->Azimuth(30.0);
  this->frames(5);
  this->expectUsed(Mapper::REFERENCE, 1e-5);
  EXPECT_EQ(this->mapper()->GetTablesBuilds(), tables);
}

TEST_F(Budget, OfTooLittleTimeIsNotKept)
{
  this->mapper()->SetFrameTimeBudget(Tiny);
  for (int i = 0; i < 20; ++i)
  {
    this->frames(1);
    this->expectUsed(Mapper::FAST, 0.0);
    EXPECT_FALSE(this->mapper()->IsBudgetKept());
  }
  EXPECT_EQ(this->mapper()->GetTablesBuilds(), 1);
}

// Before anything coarser, pixels are interpolated; unless the user has said how.
TEST_F(Budget, OfTooLittleTimeInterpolatesPixels)
{
  this->mapper()->SetFrameTimeBudget(Tiny);
  std::set<double> used;
  for (int i = 0; i < 20; ++i)
  {
    this->frames(1);
    const double tolerance = this->mapper()->GetUsedPixelTolerance();
    EXPECT_TRUE(i > 0 || tolerance == 0.0);
    if (used.insert(tolerance).second)
    {
      Scene other(this->Shown.Data);
      other.Mapper->SetAccuracyLevelToFast();
      other.Mapper->SetPixelTolerance(tolerance);
      other.Window->Render();
      EXPECT_EQ(compare(this->Shown.frame(), other.frame()).Max, 0.0) << tolerance;
    }
  }
  EXPECT_EQ(used, (std::set<double>{ 0.0, 4.0 / 255.0 }));
  this->mapper()->SetPixelTolerance(0.001);
  for (const double budget : { Tiny, Huge })
  {
    this->mapper()->SetFrameTimeBudget(budget);
    for (int i = 0; i < UntilBest; ++i)
    {
      this->frames(1);
      EXPECT_EQ(this->mapper()->GetUsedPixelTolerance(), 0.001);
    }
  }
  this->expectUsed(Mapper::REFERENCE, 1e-5);
  this->mapper()->SetViewModeToCells();
  this->frames(1);
  EXPECT_EQ(this->mapper()->GetUsedPixelTolerance(), 0.0);
}

// A frame in which light was computed doesn't tell how long drawing takes.
TEST(BudgetInLight, IsOfFramesThatOnlyDraw)
{
  LitScene scene(jitteredLattice(8, 0.15, 5, sineField()));
  scene.Mapper->CollectDiagnosticsOff();
  scene.Mapper->SetShadowMethodToAtVertices();
  scene.Mapper->SetFrameTimeBudget(Huge);
  for (int i = 0; i < 5; ++i)
  {
    scene.Sun->SetPosition(3.0, 4.0, i);
    scene.Window->Render();
    EXPECT_EQ(scene.Mapper->GetVertexLightBuilds(), i + 1);
    EXPECT_EQ(scene.Mapper->GetUsedAccuracyLevel(), Mapper::FAST);
  }
  scene.Window->Render();
  scene.Window->Render();
  EXPECT_GT(scene.Mapper->GetUsedAccuracyLevel(), Mapper::FAST);
}

TEST_F(Budget, ItsPictureIsThatOfTheLevelItSays)
{
  this->mapper()->SetFrameTimeBudget(Huge);
  for (int i = 0; i < UntilBest; ++i)
  {
    this->frames(1);
    const Image chosen = this->Shown.frame();
    const int level = this->mapper()->GetUsedAccuracyLevel();
    const double tolerance = this->mapper()->GetUsedErrorTolerance();
    Scene other(this->Shown.Data);
    other.Mapper->SetAccuracyLevel(level);
    other.Mapper->SetErrorTolerance(tolerance > 0 ? tolerance : 1.0);
    other.Window->Render();
    EXPECT_EQ(compare(chosen, other.frame()).Max, 0.0) << level << ' ' << tolerance;
  }
}

TEST_F(Budget, FollowsWhatIsSet)
{
  this->mapper()->SetFrameTimeBudget(Huge);
  this->frames(UntilBest);
  this->mapper()->SetFrameTimeBudget(Tiny);
  this->frames(2); // the first of them tells
  this->expectUsed(Mapper::FAST, 0.0);
  EXPECT_FALSE(this->mapper()->IsBudgetKept());
  this->mapper()->SetErrorBudget(0.01);
  this->frames(1);
  this->expectUsed(Mapper::DEFAULT, 0.01);
  EXPECT_FALSE(this->mapper()->IsBudgetKept());
  this->mapper()->SetFrameTimeBudget(Huge);
  this->frames(UntilBest);
  this->expectUsed(Mapper::REFERENCE, 1e-5);
  EXPECT_TRUE(this->mapper()->IsBudgetKept());
  this->mapper()->SetFrameTimeBudget(0.0);
  this->frames(1);
  this->expectUsed(Mapper::DEFAULT, 0.01);
  EXPECT_TRUE(this->mapper()->IsBudgetKept());
  this->mapper()->SetErrorBudget(0.0);
  this->frames(1);
  this->expectUsed(Mapper::DEFAULT, 1.0 / 255.0);
  this->mapper()->SetAccuracyLevelToAccurate();
  this->frames(1);
  this->expectUsed(Mapper::ACCURATE, 1.0 / 4096.0);
  this->expectPrepared(1);
}

TEST_F(Budget, OfAnErrorIsKept)
{
  setBumpyFunctions(this->Shown.property());
  this->Shown.property()->SetScalarOpacityUnitDistance(0.05);
  this->mapper()->CollectDiagnosticsOn();
  this->mapper()->SetAccuracyLevelToFast(); // not used
  vtkTetMarchFrameStatistics* statistics = this->mapper()->GetLastFrameStatistics();
  for (const double error : { 0.1, 0.01, 1.0 / 1024.0 })
  {
    for (const bool cellScalars : { false, true })
    {
      if (cellScalars)
      {
        this->Shown.drawCellScalars();
      }
      else
      {
        this->mapper()->SetScalarModeToDefault();
      }
      this->mapper()->SetErrorBudget(error);
      this->frames(1);
      this->expectUsed(Mapper::DEFAULT, error);
      EXPECT_TRUE(this->mapper()->IsBudgetKept());
      ASSERT_TRUE(this->mapper()->CompareWithGroundTruth(this->Shown.Volume));
      const double worst = statistics->GetMaximum(vtkTetMarchFrameStatistics::TRUE_ERROR);
      EXPECT_LE(worst, error);
      EXPECT_GT(worst, 0.0);
      std::cout << "[ MEASURED ] error budget " << error
                << (cellScalars ? ", cells: " : ", points: ") << worst << '\n';
    }
  }
  this->mapper()->SetErrorBudget(1e-9); // no level keeps that
  this->frames(1);
  this->expectUsed(Mapper::DEFAULT, 1e-6);
  EXPECT_FALSE(this->mapper()->IsBudgetKept());
}

TEST_F(Budget, IsNotKeptByAFrameThatIsNotDrawn)
{
  const ErrorWatch errors(this->mapper());
  this->mapper()->SetFrameTimeBudget(Huge);
  this->frames(UntilBest);
  EXPECT_TRUE(this->mapper()->IsBudgetKept());
  this->mapper()->SetMaxMemoryInBytes(1);
  this->frames(1);
  EXPECT_FALSE(this->mapper()->IsBudgetKept());
  EXPECT_EQ(errors.Errors.size(), 1u);
  this->mapper()->SetMaxMemoryInBytes(0);
  this->mapper()->SetInputData(jitteredLattice(4, 0.15, 1, sineField()));
  this->frames(UntilBest);
  EXPECT_TRUE(this->mapper()->IsBudgetKept());
  this->expectUsed(Mapper::REFERENCE, 1e-5);
}

// Their frames are measured when nothing but the camera changes.
TEST_F(Budget, EditsAreNoMeasurements)
{
  this->mapper()->SetFrameTimeBudget(Huge);
  for (int i = 0; i < 10; ++i)
  {
    this->Shown.property()->GetScalarOpacity()->AddPoint(0.8, 0.05 * i);
    this->frames(1);
    this->expectUsed(Mapper::FAST, 0.0);
  }
  for (int i = 0; i < UntilBest; ++i)
  {
    this->Shown.camera()->Azimuth(3.0);
    this->frames(1);
  }
  this->expectUsed(Mapper::REFERENCE, 1e-5);
  this->expectPrepared(1);
}
} // namespace
