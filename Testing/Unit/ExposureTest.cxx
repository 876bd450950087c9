// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Unit distances against closed forms.
#include "FirstPicture/Exposure.h"

#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace tetmarch;

// One row of pixels, each with one length of one value.
Crossings row(const std::vector<double>& lengths, double value = 1)
{
  Crossings crossings;
  crossings.Width = static_cast<int>(lengths.size());
  crossings.Height = 1;
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    crossings.List.push_back({ static_cast<int>(i), static_cast<float>(lengths[i]), value });
  }
  return crossings;
}

const auto One = [](double) { return 1.0; };

double opacityOf(double length, double unitDistance) { return -std::expm1(-length / unitDistance); }
} // namespace

TEST(Exposure, TheMedianIsHalfOpaque)
{
  const auto exposure = findExposure(row({ 1, 2, 3, 4, 5 }), One);
  ASSERT_TRUE(exposure);
  EXPECT_NEAR(opacityOf(3, *exposure), 0.5, 1e-6);
}

TEST(Exposure, OneInTwentyIsSaturatedAtMost)
{
  std::vector<double> lengths(80, 1.0);
  lengths.insert(lengths.end(), 20, 10.0);
  const auto exposure = findExposure(row(lengths), One);
  ASSERT_TRUE(exposure);
  EXPECT_NEAR(opacityOf(10, *exposure), 0.97, 1e-6);
}

// Three in four pixels see nearly nothing: the median is that of the others.
TEST(Exposure, PixelsThatShowNothingDoNotCount)
{
  std::vector<double> lengths(75, 1e-4);
  lengths.insert(lengths.end(), 25, 2.0);
  lengths.insert(lengths.end(), 25, 0.0);
  const auto exposure = findExposure(row(lengths), One);
  ASSERT_TRUE(exposure);
  EXPECT_NEAR(opacityOf(2, *exposure), 0.5, 1e-6);
}

TEST(Exposure, OfNothingThereIsNone)
{
  EXPECT_FALSE(findExposure(row({}), One));
  EXPECT_FALSE(findExposure(row({ 1, 2 }), [](double) { return 0.0; }));
  EXPECT_NEAR(exposedUnitDistance(row({ 1, 2 }), [](double) { return 0.0; }), 2, 1e-6);
  EXPECT_EQ(exposedUnitDistance(row({}), One), 1);
}

TEST(Exposure, BothLawsOfOpacity)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0, 0.0);
  opacity->AddPoint(1, 1.0);
  EXPECT_DOUBLE_EQ(extinctionOf(opacity, false)(0.5), 0.5);
  EXPECT_DOUBLE_EQ(extinctionOf(opacity, true)(0.5), std::log(2.0));
  EXPECT_NEAR(extinctionOf(opacity, true)(1), std::log(1000.0), 1e-9);
}

TEST(Exposure, TheVeilShowsWhatIsBackgroundAlone)
{
  std::vector<double> lengths(200, 10.0);
  Crossings crossings = row(lengths, 0);
  for (int i = 0; i < 10; ++i)
  {
    crossings.List[i].Value = 1;
  }
  ValueStatistics statistics;
  vtkNew<vtkPiecewiseFunction> opacity;
  const double clear = exposeFirstOpacity(statistics, crossings, {}, opacity);
  EXPECT_EQ(opacity->GetValue(0), 0);
  EXPECT_EQ(opacity->GetValue(1), 1);
  EXPECT_NEAR(opacityOf(10, clear), 0.5, 1e-6);
  const double veiled = exposeFirstOpacity(statistics, crossings, { false, true }, opacity);
  EXPECT_EQ(veiled, clear);
  EXPECT_NEAR(opacity->GetValue(0), 0.05, 1e-9); // 0.12 would be more
  EXPECT_EQ(opacity->GetValue(1), 1);
  exposeFirstOpacity(statistics, crossings, { true, false }, opacity);
  EXPECT_NEAR(opacity->GetValue(1), 0.95, 1e-12);
}

// Of values that are spread over many sizes, a power of 2 would show the largest alone.
TEST(Exposure, ThePowerIsTheOneThatShowsMost)
{
  Crossings crossings = row(std::vector<double>(1000, 1.0));
  for (std::size_t i = 0; i < crossings.List.size(); ++i)
  {
    crossings.List[i].Value = std::exp2(-10.0 * double(i) / 1000);
  }
  vtkNew<vtkPiecewiseFunction> opacity;
  exposeFirstOpacity(ValueStatistics(), crossings, {}, opacity);
  EXPECT_GT(opacity->GetValue(0.3), 0.3); // a power below 1
  for (std::size_t i = 0; i < crossings.List.size(); ++i)
  {
    crossings.List[i].Value = 0.5 + 0.5 * double(i) / 1000;
  }
  exposeFirstOpacity(ValueStatistics(), crossings, {}, opacity);
  EXPECT_LT(opacity->GetValue(0.3), 0.1);
}

// Whatever the numbers, the unit distance is one that can be divided by.
TEST(Exposure, OfLengthsAtTheEndsOfDoublePrecision)
{
  const double inf = std::numeric_limits<double>::infinity();
  for (const double length : { 1e-320, 1e-100, 1e100, 1e308, inf, std::nan("") })
  {
    const Crossings crossings = row({ length, 2 * length, 3 * length }, 0.5);
    vtkNew<vtkPiecewiseFunction> opacity;
    const double distance =
      exposeFirstOpacity(ValueStatistics(), crossings, { false, true }, opacity);
    EXPECT_TRUE(distance > 0 && std::isfinite(distance)) << length << ": " << distance;
    EXPECT_TRUE(std::isfinite(opacity->GetValue(0.5))) << length;
  }
  const auto unknown = [](double) { return std::nan(""); };
  EXPECT_EQ(exposedUnitDistance(row({ 1, 2 }), unknown), 2);
}
