// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Ranges and colours of the view modes.
#include "Diagnostics/MeasureView.h"
#include "Diagnostics/ViewColors.h"

#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;

// Of three pixels, the second of which has that value.
std::array<double, 2> rangeOf(Measure what, float value)
{
  std::vector<float> measures(12, 0.0f);
  measures[4 + static_cast<std::size_t>(what)] = value;
  return automaticRange(what, measures);
}

TEST(MeasureView, CountsBeginAtNoughtAndEndAtRoundNumbers)
{
  const double cases[][2] = { { 0, 4 }, { 1, 4 }, { 4, 4 }, { 5, 8 }, { 189, 200 }, { 200, 200 },
    { 201, 240 }, { 1000, 1000 }, { 1001, 1200 }, { 65535, 80000 } };
  for (const auto& c : cases)
  {
    for (const Measure what : { Measure::Cells, Measure::Lookups })
    {
      const auto range = rangeOf(what, static_cast<float>(c[0]));
      EXPECT_EQ(range[0], 0.0);
      EXPECT_EQ(range[1], c[1]) << c[0];
      EXPECT_EQ(std::fmod(range[1], 4.0), 0.0);
    }
  }
}

TEST(MeasureView, ErrorsHaveFourDecades)
{
  const double cases[][2] = { { 0.0039, -2 }, { 0.0101, -1 }, { 0.01, -2 }, { 1.0, 0 },
    { 1e-5, -5 }, { 0.0, -9 }, { 1e-30, -9 } };
  for (const auto& c : cases)
  {
    const auto range = rangeOf(Measure::ErrorBound, static_cast<float>(c[0]));
    EXPECT_NEAR(std::log10(range[1]), c[1], 1e-12) << c[0];
    EXPECT_NEAR(std::log10(range[0]), c[1] - 4, 1e-12) << c[0];
  }
}

TEST(MeasureView, WhatIsNotFiniteIsLeftOut)
{
  for (const float bad :
    { std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN() })
  {
    EXPECT_EQ(rangeOf(Measure::Cells, bad), rangeOf(Measure::Cells, 0.0f));
    EXPECT_EQ(rangeOf(Measure::ErrorBound, bad), rangeOf(Measure::ErrorBound, 0.0f));
  }
}

TEST(MeasureView, BadRangesAreDescribed)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto wordsOn = [](Measure what, double low, double high) {
    return describeBadRange({ what, false, { { low, high } }, nullptr });
  };
  EXPECT_EQ(wordsOn(Measure::Cells, 0.0, 10.0), "");
  EXPECT_EQ(wordsOn(Measure::Cells, -5.0, -1.0), "");
  EXPECT_EQ(wordsOn(Measure::ErrorBound, 1e-9, 1.0), "");
  EXPECT_NE(wordsOn(Measure::Cells, 10.0, 10.0).find("below the second"), std::string::npos);
  EXPECT_NE(wordsOn(Measure::Lookups, 0.0, inf).find("finite"), std::string::npos);
  EXPECT_NE(wordsOn(Measure::Lookups, nan, 1.0).find("finite"), std::string::npos);
  EXPECT_NE(wordsOn(Measure::ErrorBound, 0.0, 1.0).find("begins above 0"), std::string::npos);
  EXPECT_EQ(describeBadRange({ Measure::Cells, true, { { nan, nan } }, nullptr }), "");
}

TEST(MeasureView, TableTakesTheRangeOfEachScaleInTurn)
{
  vtkNew<vtkLookupTable> table;
  const std::vector<float> measures{ 100.0f, 200.0f, 0.002f, 0.0f };
  for (int i = 0; i < 2; ++i)
  {
    fitTable({ Measure::ErrorBound, true, {}, table }, measures);
    EXPECT_EQ(table->GetScale(), VTK_SCALE_LOG10);
    EXPECT_NEAR(table->GetTableRange()[0], 1e-6, 1e-18);
    EXPECT_NEAR(table->GetTableRange()[1], 1e-2, 1e-14);
    fitTable({ Measure::Lookups, true, {}, table }, measures);
    EXPECT_EQ(table->GetScale(), VTK_SCALE_LINEAR);
    EXPECT_EQ(table->GetTableRange()[0], 0.0);
    EXPECT_EQ(table->GetTableRange()[1], 200.0);
    fitTable({ Measure::Cells, false, { { -3.0, 7.0 } }, table }, measures);
    EXPECT_EQ(table->GetTableRange()[0], -3.0);
    EXPECT_EQ(table->GetTableRange()[1], 7.0);
  }
}

// Equal steps of a value are equal steps of lightness.
TEST(ViewColors, LightnessIsLinear)
{
  vtkNew<vtkLookupTable> table;
  setViewColors(table);
  const auto lightness = [&](vtkIdType i)
  {
    double rgba[4];
    double lab[3];
    table->GetTableValue(i, rgba);
    vtkMath::RGBToLab(rgba, lab);
    return lab[0];
  };
  const double first = lightness(0);
  const double last = lightness(255);
  EXPECT_NEAR(first, 18.0, 2.0);
  EXPECT_NEAR(last, 97.0, 2.0);
  double before = first - 0.1;
  for (int i = 0; i < 256; ++i)
  {
    EXPECT_NEAR(lightness(i), first + (last - first) * i / 255.0, 2.0) << i;
    EXPECT_GT(lightness(i), before) << i;
    before = lightness(i);
  }
}
} // namespace
