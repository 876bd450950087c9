// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Magnitudes of vectors and their components, from the least double to the greatest.
#include "Scalars/TupleScalar.h"

#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace
{
using namespace tetmarch;

using Vector = std::vector<double>;
using Limits = std::numeric_limits<double>;

TEST(TupleScalar, MagnitudesOfAnyNumberOfComponents)
{
  EXPECT_EQ(magnitudeOf(Vector{ 0, 0, 0 }), 0.0);
  EXPECT_EQ(magnitudeOf(Vector{ 3, -4 }), 5.0);
  EXPECT_EQ(magnitudeOf(Vector{ 1, 2, -2 }), 3.0);
  EXPECT_EQ(magnitudeOf(Vector{ 1, 1, 1, -1 }), 2.0);
  EXPECT_EQ(magnitudeOf(std::vector<std::uint8_t>{ 180, 240 }), 300.0);
}

// Where squares would be 0, subnormal or infinite.
TEST(TupleScalar, MagnitudesAreExactAtAnySize)
{
  for (int exponent = -1060; exponent < 1020; ++exponent)
  {
    const double unit = std::ldexp(1.0, exponent);
    EXPECT_DOUBLE_EQ(magnitudeOf(Vector{ 2 * unit, unit, -2 * unit }), 3 * unit) << exponent;
    EXPECT_DOUBLE_EQ(magnitudeOf(Vector{ 0, unit, 0 }), unit) << exponent;
  }
  const double least = Limits::denorm_min();
  EXPECT_EQ(magnitudeOf(Vector{ 3 * least, 4 * least }), 5 * least);
  EXPECT_EQ(magnitudeOf(Vector{ Limits::max(), 1.0 }), Limits::max());
  EXPECT_EQ(magnitudeOf(Vector{ Limits::max(), Limits::lowest(), 1.0 }), Limits::max());
}

TEST(TupleScalar, WhatIsNotFiniteStaysSo)
{
  for (const double bad : { Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity() })
  {
    for (const Vector& vector : { Vector{ bad, 1, 2 }, Vector{ 1, 2, bad }, Vector{ bad } })
    {
      EXPECT_FALSE(std::isfinite(magnitudeOf(vector)));
    }
    EXPECT_EQ(scalarOf(Vector{ 1, bad, 7 }, { false, 2 }), 7.0);
  }
}

TEST(TupleScalar, AComponentKeepsItsSign)
{
  const Vector vector{ 3, -4, 12 };
  EXPECT_EQ(scalarOf(vector, {}), 3.0);
  EXPECT_EQ(scalarOf(vector, { false, 1 }), -4.0);
  EXPECT_EQ(scalarOf(vector, { false, 2 }), 12.0);
  EXPECT_EQ(scalarOf(vector, { true, 0 }), 13.0);
}
} // namespace
