// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/RangeText.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <locale>
#include <random>

namespace
{
using namespace tetmarch;

std::string textOf(double low, double high)
{
  const auto [first, last] = rangeText(low, high);
  return first + " to " + last;
}
} // namespace

TEST(RangeText, HasAsManyDigitsAsTellTheEndsApart)
{
  EXPECT_EQ(textOf(0.0, 1.0), "0 to 1");
  EXPECT_EQ(textOf(-0.0, 1.0 / 3.0), "0 to 0.333333");
  EXPECT_EQ(textOf(293.15, 913.2345678), "293.15 to 913.235");
  EXPECT_EQ(textOf(101324.9, 101325.4), "101324.9 to 101325.4");
  EXPECT_EQ(textOf(101325.04, 101325.44), "101325.04 to 101325.44");
  EXPECT_EQ(textOf(1e9 + 0.25, 1e9 + 0.5), "1000000000.25 to 1000000000.5");
  EXPECT_EQ(textOf(-1.0, -1.0 + 4e-12), "-1 to -0.999999999996");
  EXPECT_EQ(textOf(1.0, 1.0 + DBL_EPSILON), "1 to 1.0000000000000002");
  EXPECT_EQ(textOf(0.0, 4.9e-324), "0 to 4.94066e-324");
  EXPECT_EQ(textOf(-DBL_MAX, DBL_MAX), "-1.79769e+308 to 1.79769e+308");
}

TEST(RangeText, WholeNumbersHaveAllDigits)
{
  EXPECT_EQ(textOf(1.0, 1234567.0), "1 to 1234567");
  EXPECT_EQ(textOf(-1000000007.0, 9999999999.0), "-1000000007 to 9999999999");
  EXPECT_EQ(textOf(0.0, 1e12), "0 to 1e+12");
}

TEST(RangeText, EqualEndsHaveTheDigitsOfAFloat)
{
  EXPECT_EQ(textOf(101325.4f, 101325.4f), "101325.4 to 101325.4");
  EXPECT_EQ(textOf(0.1f, 0.1f), "0.1 to 0.1");
}

// What is printed is within a hundredth of the range, and differs where the ends do.
TEST(RangeText, IsNearTheNumber)
{
  std::mt19937 random(7);
  for (int i = 0; i < 100000; ++i)
  {
    const auto unit = [&random] { return random() / 4294967296.0; };
    const double low = (unit() - 0.5) * std::pow(10.0, 40.0 * unit() - 20.0);
    double high = low + std::abs(low) * std::pow(10.0, -16.0 * unit());
    high = high > low ? high : std::nextafter(low, DBL_MAX);
    const auto [first, last] = rangeText(low, high);
    ASSERT_NE(first, last) << i;
    const double allowed = 0.01 * (high - low) + DBL_EPSILON * std::abs(high);
    ASSERT_NEAR(std::stod(first), low, allowed) << first;
    ASSERT_NEAR(std::stod(last), high, allowed) << last;
  }
}

TEST(RangeText, IsThatOfTheClassicLocale)
{
  struct Comma : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const std::string text = textOf(1000.5, 20000.25);
  std::locale::global(before);
  EXPECT_EQ(text, "1000.5 to 20000.2");
}
