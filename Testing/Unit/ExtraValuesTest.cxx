// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Components that are drawn together with the first one, as values of a lattice.
#include "StoredScalars.h"

#include "vtkType.h"

#include <cmath>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

std::vector<StoredValues> storedTogether(
  vtkDataArray* array, int first, const std::vector<int>& extra, double unit = 0)
{
  return storeValues({ array, false, ComponentMix::Independent, { false, first }, extra, unit });
}

TEST(ExtraValues, HaveTheirOwnRange)
{
  const auto array = arrayOf(VTK_UNSIGNED_CHAR, { 10, 20, 15 }, 2, 0);
  setComponent(array, 1, { 200, 100, 150 });
  const auto all = storedTogether(array, 0, { 1 });
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1].Type, ValueType::UInt8);
  EXPECT_EQ(all[1].Bytes, (std::vector<std::uint8_t>{ 100, 0, 50 }));
  EXPECT_EQ(all[1].Range.Low, 100.0);
  EXPECT_EQ(all[1].Range.High, 200.0);
  expectValues(all[0], { 10, 20, 15 });
  expectValues(all[1], { 200, 100, 150 });
}

TEST(ExtraValues, AreDividedByTheirUnit)
{
  const auto bytes = arrayOf(VTK_UNSIGNED_CHAR, { 0, 51, 255 }, 4, 2);
  const auto ofBytes = storedTogether(bytes, 3, { 2 }, 255);
  EXPECT_EQ(ofBytes[1].Bytes, (std::vector<std::uint8_t>{ 0, 51, 255 }));
  EXPECT_EQ(ofBytes[1].Scale, 1.0f);
  EXPECT_EQ(ofBytes[1].Range.Low, 0.0);
  EXPECT_EQ(ofBytes[1].Range.High, 255.0);
  EXPECT_EQ(ofBytes[1].scalar(1), 0.2f);
  for (const int type : { VTK_SHORT, VTK_INT, VTK_DOUBLE })
  {
    const auto all = storedTogether(arrayOf(type, { -5, 51, 1000 }, 4, 2), 3, { 2 }, 255);
    EXPECT_EQ(all[1].Floats, (std::vector<float>{ 0.0f, 0.2f, 1.0f })) << type;
  }
}

TEST(ExtraValues, ThatAreNotFiniteHideTheFirst)
{
  const double nan = std::nan("");
  const auto array = arrayOf(VTK_FLOAT, { 0, 1, 2, nan }, 3, 0);
  setComponent(array, 1, { 5, nan, 7, 8 });
  setComponent(array, 2, { 1, 2, nan, 3 });
  for (const double unit : { 0.0, 1.0 })
  {
    const auto all = storedTogether(array, 0, { 1, 2 }, unit);
    EXPECT_EQ(
      all[0].Floats, (std::vector<float>{ 0.0f, UndrawnScalar, UndrawnScalar, UndrawnScalar }));
    EXPECT_FALSE(all[0].Range.AllFinite);
    EXPECT_EQ(all[0].Range.High, 2.0);
    EXPECT_EQ(all[1].Floats[1], 0.0f);
    EXPECT_EQ(all[2].Floats[2], 0.0f);
  }
  setComponent(array, 0, { 0, 1, 2, 3 });
  const auto all = storedTogether(array, 0, { 1 });
  EXPECT_EQ(all[0].Floats[1], UndrawnScalar);
  EXPECT_FALSE(all[0].Range.AllFinite);
}
} // namespace
