// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Scalars are of the type and have the extremes that their cases claim.
#include "CaseAccess.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkTypeInt64Array.h"
#include "vtkTypeUInt64Array.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch::testing;

template <typename T>
void expectWholeType(vtkDataArray* array, int vtkType)
{
  ASSERT_NE(array, nullptr);
  EXPECT_EQ(array->GetDataType(), vtkType);
  const auto* values = static_cast<const T*>(array->GetVoidPointer(0));
  const auto [low, high] = std::minmax_element(values, values + array->GetNumberOfTuples());
  EXPECT_EQ(*low, std::numeric_limits<T>::lowest());
  EXPECT_EQ(*high, std::numeric_limits<T>::max());
}

vtkSmartPointer<vtkDataArray> pointsOf(const std::string& name)
{
  return gridOf(name)->GetPointData()->GetArray("f");
}

vtkSmartPointer<vtkDataArray> cellsOf(const std::string& name)
{
  EXPECT_TRUE(findHardCase(name)->CellScalars);
  return gridOf(name)->GetCellData()->GetArray("c");
}

TEST(HardScalars, IntegersOfEveryType)
{
  expectWholeType<char>(pointsOf("points-char"), VTK_CHAR);
  expectWholeType<signed char>(pointsOf("points-signed-char"), VTK_SIGNED_CHAR);
  expectWholeType<unsigned char>(pointsOf("points-unsigned-char"), VTK_UNSIGNED_CHAR);
  expectWholeType<short>(pointsOf("points-short"), VTK_SHORT);
  expectWholeType<unsigned short>(pointsOf("points-unsigned-short"), VTK_UNSIGNED_SHORT);
  expectWholeType<int>(pointsOf("points-int"), VTK_INT);
  expectWholeType<unsigned int>(pointsOf("points-unsigned-int"), VTK_UNSIGNED_INT);
  expectWholeType<long>(pointsOf("points-long"), VTK_LONG);
  expectWholeType<unsigned long>(pointsOf("points-unsigned-long"), VTK_UNSIGNED_LONG);
  expectWholeType<long long>(pointsOf("points-long-long"), VTK_LONG_LONG);
  expectWholeType<unsigned long long>(
    pointsOf("points-unsigned-long-long"), VTK_UNSIGNED_LONG_LONG);
  expectWholeType<vtkIdType>(pointsOf("points-id-type"), VTK_ID_TYPE);

  expectWholeType<unsigned char>(cellsOf("cells-unsigned-char"), VTK_UNSIGNED_CHAR);
  expectWholeType<int>(cellsOf("cells-int"), VTK_INT);
  expectWholeType<long long>(cellsOf("cells-long-long"), VTK_LONG_LONG);
  expectWholeType<unsigned long long>(cellsOf("cells-unsigned-long-long"), VTK_UNSIGNED_LONG_LONG);
}

TEST(HardScalars, Bits)
{
  for (const auto& bits : { pointsOf("points-bit"), cellsOf("cells-bit") })
  {
    EXPECT_EQ(bits->GetDataType(), VTK_BIT);
    double ones = 0.0;
    for (vtkIdType i = 0; i < bits->GetNumberOfTuples(); ++i)
    {
      ones += bits->GetComponent(i, 0);
    }
    EXPECT_GT(ones, bits->GetNumberOfTuples() / 4.0);
    EXPECT_LT(ones, bits->GetNumberOfTuples() * 0.75);
  }
}

TEST(HardScalars, IntegersBeyondDoubles)
{
  const auto lostInDouble = [](auto* array)
  {
    ASSERT_NE(array, nullptr);
    int lost = 0;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      const auto value = array->GetValue(i);
      lost += static_cast<decltype(array->GetValue(i))>(static_cast<double>(value)) != value;
    }
    EXPECT_GT(lost, array->GetNumberOfTuples() / 4);
  };
  const auto signedValues = pointsOf("int64-beyond-double");
  lostInDouble(vtkTypeInt64Array::SafeDownCast(signedValues));
  const auto unsignedValues = pointsOf("uint64-beyond-signed");
  lostInDouble(vtkTypeUInt64Array::SafeDownCast(unsignedValues));
  EXPECT_GT(vtkTypeUInt64Array::SafeDownCast(unsignedValues)->GetValueRange()[0],
    static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()));
}

// How many values a predicate holds for.
template <typename Predicate>
vtkIdType count(vtkDataArray* values, Predicate&& predicate)
{
  vtkIdType found = 0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    found += predicate(values->GetComponent(i, 0)) ? 1 : 0;
  }
  return found;
}

TEST(HardScalars, NotFinite)
{
  const auto isNan = [](double x) { return std::isnan(x); };
  const auto isInf = [](double x) { return std::isinf(x); };
  EXPECT_EQ(count(pointsOf("nan-at-some-points"), isNan), 21); // of 343
  EXPECT_EQ(count(pointsOf("inf-at-some-points"), isInf), 21);
  EXPECT_EQ(count(pointsOf("nan-everywhere"), isNan), 343);
  EXPECT_EQ(count(pointsOf("inf-everywhere"), isInf), 343);
  EXPECT_EQ(count(cellsOf("nan-in-some-cells"), isNan), 77); // of 1296
}

TEST(HardScalars, Magnitudes)
{
  const auto base = pointsOf("jittered-cube");
  for (const char* factor : { "1e30", "1e-30", "1e-40", "1e300", "1e-300" })
  {
    const auto scaled = pointsOf(std::string("values-times-") + factor);
    for (vtkIdType i = 0; i < base->GetNumberOfTuples(); ++i)
    {
      EXPECT_DOUBLE_EQ(scaled->GetComponent(i, 0), std::stod(factor) * base->GetComponent(i, 0));
    }
  }
  EXPECT_EQ(pointsOf("constant")->GetRange()[0], pointsOf("constant")->GetRange()[1]);
  const auto nearlyEqual = pointsOf("values-nearly-equal");
  EXPECT_NEAR(nearlyEqual->GetRange()[1] / nearlyEqual->GetRange()[0] - 1.0, 1e-7, 1e-12);
  EXPECT_EQ(count(pointsOf("outlier"), [](double x) { return x == 1e30; }), 1);
  EXPECT_EQ(count(pointsOf("outlier"), [](double x) { return x <= 1.0; }), 342);
  EXPECT_EQ(count(cellsOf("outlier-in-cells"), [](double x) { return x == 1e30; }), 1);
}
} // namespace
