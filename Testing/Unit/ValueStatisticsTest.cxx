// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/FirstFunctions.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{
using tetmarch::Sample;
using tetmarch::ValueStatistics;

ValueStatistics statisticsOf(const std::vector<Sample>& samples, bool lattice = false)
{
  return tetmarch::computeStatistics(samples, std::nullopt, lattice);
}

struct Functions
{
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;

  explicit Functions(const ValueStatistics& statistics)
  {
    tetmarch::makeFirstColors(statistics, this->Color);
    tetmarch::makeFirstOpacity(statistics, {}, this->Opacity);
  }
};

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

TEST(ValueStatistics, NothingGivesAUsableRange)
{
  const auto statistics = statisticsOf({});
  EXPECT_LT(statistics.Range[0], statistics.Range[1]);
  EXPECT_GT(Functions{ statistics }.Opacity->GetSize(), 1);
}

TEST(ValueStatistics, EqualValuesGetARoundRange)
{
  const auto statistics = statisticsOf(MakeSamples({ 7, 7, 7 }));
  EXPECT_DOUBLE_EQ(statistics.Range[0], 3.5);
  EXPECT_DOUBLE_EQ(statistics.Range[1], 10.5);
  const auto zero = statisticsOf(MakeSamples({ 0 }));
  EXPECT_DOUBLE_EQ(zero.Range[0], -0.5);
  EXPECT_DOUBLE_EQ(zero.Range[1], 0.5);
}

TEST(ValueStatistics, RangeLeavesOutTwoPercentAtEachEnd)
{
  auto samples = MakeRamp();
  samples[1000].Value = 1e9;
  samples[0].Value = -1e9;
  const auto statistics = statisticsOf(samples);
  EXPECT_NEAR(statistics.Range[0], 20.0, 1.0);
  EXPECT_NEAR(statistics.Range[1], 980.0, 1.0);
}

TEST(ValueStatistics, CellsCountByTheAreaTheyCover)
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
  EXPECT_LT(statisticsOf(samples).Range[1], 1.0);
  // A hundred cells of a thousandth of the volume of twenty others: 5 % by area, 0.5 % by volume.
  samples.clear();
  for (int i = 0; i < 100; ++i)
  {
    samples.push_back({ 1000.0 + i, 1e-3 });
  }
  for (int i = 0; i < 20; ++i)
  {
    samples.push_back({ i * 0.01, 1.0 });
  }
  EXPECT_GT(statisticsOf(samples).Range[1], 1000.0);
}

TEST(ValueStatistics, RareValuesStillGiveARange)
{
  std::vector<double> values(1000, 5.0);
  values[3] = 8.0;
  const auto statistics = statisticsOf(MakeSamples(values));
  EXPECT_DOUBLE_EQ(statistics.Range[0], 5.0);
  EXPECT_DOUBLE_EQ(statistics.Range[1], 8.0);
}

// As of a scan: air with noise, and a tenth of something in it.
TEST(ValueStatistics, OfImagesWhatIsNotAirGivesTheRange)
{
  std::mt19937 random(2);
  std::vector<double> values;
  for (int i = 0; i < 10000; ++i)
  {
    const double u = static_cast<double>(random()) / 4294967296.0;
    values.push_back(i < 9000 ? 2.0 * u : 100.0 + 100.0 * u);
  }
  const auto statistics = statisticsOf(MakeSamples(values), true);
  EXPECT_NEAR(statistics.Range[0], 1.0, 1.0);
  EXPECT_NEAR(statistics.Range[1], 198.0, 1.0);
  EXPECT_NEAR(statistics.Background, 1.0, 1.0);
  EXPECT_LT(Functions(statistics).Opacity->GetValue(2.0), 1e-9);
  EXPECT_NEAR(statisticsOf(MakeSamples(values)).Range[1], 180.0, 5.0);
}

TEST(ValueStatistics, OfImagesWithoutAirTheRangeIsThatOfMeshes)
{
  EXPECT_EQ(statisticsOf(MakeRamp(), true).Range, statisticsOf(MakeRamp()).Range);
  const auto one = statisticsOf(MakeSamples({ 7, 7 }), true);
  EXPECT_DOUBLE_EQ(one.Range[0], 3.5);
  const std::array<double, 2> given{ { -3.0, 2000.0 } };
  EXPECT_EQ(tetmarch::computeStatistics(MakeRamp(), given, true).Range, given);
}

TEST(ValueStatistics, GivenRangeIsKept)
{
  const auto statistics =
    tetmarch::computeStatistics(MakeRamp(), std::array<double, 2>{ { -3.0, 2000.0 } }, false);
  EXPECT_EQ(statistics.Range[0], -3.0);
  EXPECT_EQ(statistics.Range[1], 2000.0);
}

TEST(ValueStatistics, WithoutAModeTheLowEndIsBackground)
{
  const auto statistics = statisticsOf(MakeRamp());
  EXPECT_EQ(statistics.Background, statistics.Range[0]);
}

TEST(ValueStatistics, ModeIsBackgroundAndClear)
{
  std::mt19937 random(1);
  std::vector<double> values;
  for (int i = 0; i < 10000; ++i)
  {
    const double u = static_cast<double>(random()) / 4294967296.0;
    values.push_back(i < 4000 ? 0.4 + 0.001 * u : u);
  }
  const auto statistics = statisticsOf(MakeSamples(values));
  EXPECT_NEAR(statistics.Background, 0.4005, 0.004);

  const Functions functions(statistics);
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

TEST(ValueStatistics, BackgroundAtTheHighEndTurnsOpacityRound)
{
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i)
  {
    values.push_back(i < 500 ? 1.0 : i / 1000.0 - 0.4);
  }
  const auto statistics = statisticsOf(MakeSamples(values));
  EXPECT_NEAR(statistics.Background, 1.0, 0.01);
  const Functions functions(statistics);
  EXPECT_LT(functions.Opacity->GetValue(1.0), 0.001);
  EXPECT_DOUBLE_EQ(functions.Opacity->GetValue(statistics.Range[0]), 1.0);
  EXPECT_NE(functions.Color->GetColorSpace(), VTK_CTF_DIVERGING);
}

// Values whose differences overflow, or are parts of the least number that is no normal one.
TEST(ValueStatistics, ValuesAtTheEndsOfDoublePrecision)
{
  constexpr double most = std::numeric_limits<double>::max();
  constexpr double least = std::numeric_limits<double>::denorm_min();
  for (const std::vector<double>& values :
    { std::vector<double>{ -most, most }, { most, most }, { -most, 0, most / 2, most },
      { 0, least, 2 * least, 3 * least }, { -least, least }, { 1e300, 1e300 + 1e284 } })
  {
    for (const bool lattice : { false, true })
    {
      const auto statistics = statisticsOf(MakeSamples(values), lattice);
      EXPECT_LT(statistics.Range[0], statistics.Range[1]);
      EXPECT_TRUE(std::isfinite(statistics.Range[1] - statistics.Range[0]));
      EXPECT_GE(statistics.Background, statistics.Range[0]);
      EXPECT_LE(statistics.Background, statistics.Range[1]);
      const Functions functions(statistics);
      for (const double value : values)
      {
        EXPECT_GE(functions.Opacity->GetValue(value), 0.0);
        EXPECT_LE(functions.Opacity->GetValue(value), 1.0);
      }
    }
  }
  for (const std::array<double, 2>& given :
    { std::array<double, 2>{ { -most, most } }, { { 0, least } } })
  {
    const auto statistics = tetmarch::computeStatistics(MakeRamp(), given, true);
    EXPECT_LT(statistics.Range[0], statistics.Range[1]);
    EXPECT_TRUE(std::isfinite(statistics.Range[1] - statistics.Range[0]));
    EXPECT_TRUE(std::isfinite(statistics.Background));
  }
}

TEST(ValueStatistics, CellsOfAnySizeCount)
{
  for (const double volume : { 1e-300, 1e300 })
  {
    const auto statistics = statisticsOf({ { 1, volume }, { 2, volume }, { 3, volume } });
    EXPECT_EQ(statistics.Range, (std::array<double, 2>{ { 1, 3 } }));
  }
}
