// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DefaultTransferFunction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using tetmarch::ComputeStatistics;
using tetmarch::MakeDefaultTransferFunctions;
using tetmarch::Sample;

std::vector<Sample> MakeSamples(const std::vector<double>& values)
{
  std::vector<Sample> samples;
  for (double value : values)
  {
    samples.push_back({ value, 1.0 });
  }
  return samples;
}

/// 0, 1, ..., 1000
std::vector<Sample> MakeRamp()
{
  std::vector<double> values;
  for (int i = 0; i <= 1000; ++i)
  {
    values.push_back(i);
  }
  return MakeSamples(values);
}
} // namespace

TEST(DefaultTransferFunction, NothingGivesAUsableRange)
{
  const auto statistics = ComputeStatistics({});
  EXPECT_LT(statistics.Range[0], statistics.Range[1]);
  EXPECT_NO_THROW(MakeDefaultTransferFunctions(statistics));
}

TEST(DefaultTransferFunction, EqualValuesGetARoundRange)
{
  const auto statistics = ComputeStatistics(MakeSamples({ 7, 7, 7 }));
  EXPECT_DOUBLE_EQ(statistics.Range[0], 3.5);
  EXPECT_DOUBLE_EQ(statistics.Range[1], 10.5);
  const auto zero = ComputeStatistics(MakeSamples({ 0 }));
  EXPECT_DOUBLE_EQ(zero.Range[0], -0.5);
  EXPECT_DOUBLE_EQ(zero.Range[1], 0.5);
}

TEST(DefaultTransferFunction, RangeLeavesOutTwoPercentAtEachEnd)
{
  auto samples = MakeRamp();
  samples[1000].Value = 1e9;
  samples[0].Value = -1e9;
  const auto statistics = ComputeStatistics(samples);
  EXPECT_NEAR(statistics.Range[0], 20.0, 1.0);
  EXPECT_NEAR(statistics.Range[1], 980.0, 1.0);
}

TEST(DefaultTransferFunction, CellsCountByTheAreaTheyCover)
{
  // A thousand wall cells of 1e-6 of the volume of a hundred others: 1 % of the value range's
  // weight would be theirs by count, 1e-4 is by area.
  std::vector<Sample> samples;
  for (int i = 0; i < 1000; ++i)
  {
    samples.push_back({ 1000.0 + i, 1e-6 });
  }
  for (int i = 0; i < 100; ++i)
  {
    samples.push_back({ i * 0.01, 1.0 });
  }
  EXPECT_LT(ComputeStatistics(samples).Range[1], 1.0);
}

TEST(DefaultTransferFunction, RareValuesStillGiveARange)
{
  std::vector<double> values(1000, 5.0);
  values[3] = 8.0;
  const auto statistics = ComputeStatistics(MakeSamples(values));
  EXPECT_DOUBLE_EQ(statistics.Range[0], 5.0);
  EXPECT_DOUBLE_EQ(statistics.Range[1], 8.0);
}

// As of a scan: air with noise, and a tenth of something in it.
TEST(DefaultTransferFunction, OfImagesWhatIsNotAirGivesTheRange)
{
  std::mt19937 random(2);
  std::vector<double> values;
  for (int i = 0; i < 10000; ++i)
  {
    const double u = static_cast<double>(random()) / 4294967296.0;
    values.push_back(i < 9000 ? 2.0 * u : 100.0 + 100.0 * u);
  }
  const auto statistics =
    ComputeStatistics(MakeSamples(values), std::nullopt, tetmarch::DataKind::IMAGE);
  EXPECT_NEAR(statistics.Range[0], 1.0, 1.0);
  EXPECT_NEAR(statistics.Range[1], 198.0, 1.0);
  EXPECT_NEAR(statistics.Background, 1.0, 1.0);
  EXPECT_LT(MakeDefaultTransferFunctions(statistics).Opacity->GetValue(2.0), 1e-9);
  EXPECT_NEAR(ComputeStatistics(MakeSamples(values)).Range[1], 180.0, 5.0);
}

TEST(DefaultTransferFunction, OfImagesWithoutAirTheRangeIsThatOfMeshes)
{
  EXPECT_EQ(ComputeStatistics(MakeRamp(), std::nullopt, tetmarch::DataKind::IMAGE).Range,
    ComputeStatistics(MakeRamp()).Range);
  const auto one =
    ComputeStatistics(MakeSamples({ 7, 7 }), std::nullopt, tetmarch::DataKind::IMAGE);
  EXPECT_DOUBLE_EQ(one.Range[0], 3.5);
  const std::array<double, 2> given{ { -3.0, 2000.0 } };
  EXPECT_EQ(ComputeStatistics(MakeRamp(), given, tetmarch::DataKind::IMAGE).Range, given);
}

TEST(DefaultTransferFunction, GivenRangeIsKept)
{
  const auto statistics = ComputeStatistics(MakeRamp(), std::array<double, 2>{ { -3.0, 2000.0 } });
  EXPECT_EQ(statistics.Range[0], -3.0);
  EXPECT_EQ(statistics.Range[1], 2000.0);
}

TEST(DefaultTransferFunction, WithoutAModeTheLowEndIsBackground)
{
  const auto statistics = ComputeStatistics(MakeRamp());
  EXPECT_EQ(statistics.Background, statistics.Range[0]);
}

TEST(DefaultTransferFunction, ModeIsBackgroundAndClear)
{
  std::mt19937 random(1);
  std::vector<double> values;
  for (int i = 0; i < 10000; ++i)
  {
    const double u = static_cast<double>(random()) / 4294967296.0;
    values.push_back(i < 4000 ? 0.4 + 0.001 * u : u);
  }
  const auto statistics = ComputeStatistics(MakeSamples(values));
  EXPECT_NEAR(statistics.Background, 0.4005, 0.004);

  const auto functions = MakeDefaultTransferFunctions(statistics);
  EXPECT_EQ(functions.Color->GetColorSpace(), VTK_CTF_DIVERGING);
  EXPECT_EQ(functions.Opacity->GetValue(statistics.Background), 0.0);
  EXPECT_LT(functions.Opacity->GetValue(0.4), 0.001);
  EXPECT_LT(functions.Opacity->GetValue(0.45), 0.01);
  EXPECT_DOUBLE_EQ(functions.Opacity->GetValue(statistics.Range[1]), 1.0);
  const double reach = statistics.Range[1] - statistics.Background;
  const double half = statistics.Background + (0.05 + 0.95 * 0.5) * reach;
  EXPECT_NEAR(functions.Opacity->GetValue(half), 0.25, 1e-9);
  double rgb[3];
  functions.Color->GetColor(statistics.Background, rgb);
  EXPECT_NEAR(rgb[0], 0.865, 1e-3);
  EXPECT_NEAR(rgb[2], 0.865, 1e-3);
}

TEST(DefaultTransferFunction, BackgroundAtTheHighEndTurnsOpacityRound)
{
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i)
  {
    values.push_back(i < 500 ? 1.0 : i / 1000.0 - 0.4);
  }
  const auto statistics = ComputeStatistics(MakeSamples(values));
  EXPECT_NEAR(statistics.Background, 1.0, 0.01);
  const auto functions = MakeDefaultTransferFunctions(statistics);
  EXPECT_LT(functions.Opacity->GetValue(1.0), 0.001);
  EXPECT_DOUBLE_EQ(functions.Opacity->GetValue(statistics.Range[0]), 1.0);
  EXPECT_NE(functions.Color->GetColorSpace(), VTK_CTF_DIVERGING);
}

TEST(UnitDistance, MeanRayHasOpticalDepthOne)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(1.0, 1.0);
  // Half of the volume with opacity 0.5: extinction 0.25 / d on average, along a side of 10.
  const std::vector<Sample> samples = { { 0.5, 4.0 }, { 0.0, 4.0 } };
  EXPECT_NEAR(tetmarch::ChooseUnitDistance(samples, opacity, 10.0 * std::sqrt(3.0)), 2.5, 1e-12);
}

TEST(UnitDistance, StaysWithinItsLimits)
{
  vtkNew<vtkPiecewiseFunction> clear;
  clear->AddPoint(0.0, 0.0);
  const std::vector<Sample> samples = { { 0.5, 1.0 } };
  const double diagonal = 10.0 * std::sqrt(3.0);
  EXPECT_NEAR(tetmarch::ChooseUnitDistance(samples, clear, diagonal), 0.1, 1e-12);
  EXPECT_NEAR(tetmarch::ChooseUnitDistance({}, clear, diagonal), 10.0, 1e-12);
  EXPECT_EQ(tetmarch::ChooseUnitDistance(samples, clear, 0.0), 1.0);
}
