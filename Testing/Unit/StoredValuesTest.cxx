// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays of every type become the values of a lattice: what is kept, borrowed and copied, and that
// each value comes back from what is stored.
#include "StoredScalars.h"

#include "vtkType.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr int Types[] = { VTK_BIT, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
  VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
  VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE };

TEST(StoredValues, OfEveryType)
{
  std::mt19937 random(1);
  for (const int type : Types)
  {
    for (const int components : { 1, 3 })
    {
      SCOPED_TRACE(vtkImageScalarTypeNameMacro(type));
      const double low = std::max(vtkDataArray::GetDataTypeMin(type), -1e6);
      const double high = std::min(vtkDataArray::GetDataTypeMax(type), 1e6);
      std::vector<double> values{ low, high };
      for (int i = 0; i < 500; ++i)
      {
        values.push_back(std::floor(low + uniform(random) * (high - low)));
      }
      const auto array = arrayOf(type, values, components, components - 1);
      const StoredValues stored = storedOf(array, { false, components - 1 });
      EXPECT_EQ(stored.Type, expectedType(type));
      EXPECT_EQ(stored.Range.Low, low);
      EXPECT_EQ(stored.Range.High, high);
      EXPECT_TRUE(stored.Range.AllFinite);
      expectValues(stored, values);
    }
  }
}

TEST(StoredValues, BytesAndWordsAreBorrowed)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT })
  {
    const std::vector<double> values{ 4, 20, 12, 16 };
    const auto array = arrayOf(type, values);
    StoredValues stored = storedOf(array);
    EXPECT_EQ(stored.Data, array->GetVoidPointer(0));
    EXPECT_EQ(stored.Borrowed, array);
    EXPECT_TRUE(stored.Bytes.empty() && stored.Words.empty() && stored.Floats.empty());
    expectValues(stored, values, 7e-7);
    const StoredValues moved = std::move(stored);
    EXPECT_EQ(moved.Data, array->GetVoidPointer(0));
    // It lives as long as it is borrowed.
    EXPECT_EQ(array->GetReferenceCount(), 2);
  }
}

// All values of both types, in the order of the GPU's formula.
TEST(StoredValues, WholeRangesAreWhatTheGpuReads)
{
  std::vector<double> words;
  for (int i = 0; i < 65536; ++i)
  {
    words.push_back(i);
  }
  const std::vector<double> bytes(words.begin(), words.begin() + 256);
  for (const auto& values : { bytes, words })
  {
    const StoredValues stored =
      storedOf(arrayOf(values.size() == 256 ? VTK_UNSIGNED_CHAR : VTK_UNSIGNED_SHORT, values));
    EXPECT_EQ(stored.Scale, 1.0f);
    EXPECT_EQ(stored.Offset, 0.0f);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      EXPECT_EQ(stored.read<double>(i), values[i] / (double(values.size()) - 1)) << i;
    }
    expectValues(stored, values);
  }
}

// Where Scale u + Offset would lose digits: 60000..60010 would be off by 4e-4.
TEST(StoredValues, NarrowRangesFarFromZeroAreMoved)
{
  for (const double low : { 100.0, 245.0 })
  {
    const std::vector<double> values{ low, low + 10, low + 3, low + 7, low + 1 };
    const auto array = arrayOf(VTK_UNSIGNED_CHAR, values);
    const StoredValues stored = storedOf(array);
    EXPECT_EQ(stored.Type, ValueType::UInt8);
    EXPECT_NE(stored.Data, array->GetVoidPointer(0));
    EXPECT_EQ(stored.Offset, 0.0f);
    expectValues(stored, values);
  }
  const std::vector<double> values{ 60000, 60010, 60003 };
  const StoredValues stored = storedOf(arrayOf(VTK_UNSIGNED_SHORT, values));
  EXPECT_EQ(stored.Words, (std::vector<std::uint16_t>{ 0, 10, 3 }));
  expectValues(stored, values);
}

TEST(StoredValues, SignedOnesAreMovedExactly)
{
  const StoredValues bytes = storedOf(arrayOf(VTK_SIGNED_CHAR, { -128, 127, -1, 0 }));
  EXPECT_EQ(bytes.Bytes, (std::vector<std::uint8_t>{ 0, 255, 127, 128 }));
  EXPECT_EQ(bytes.Scale, 1.0f);
  const StoredValues words = storedOf(arrayOf(VTK_SHORT, { -1024, 3071, -32, 0 }));
  EXPECT_EQ(words.Words, (std::vector<std::uint16_t>{ 0, 4095, 992, 1024 }));
  expectValues(words, { -1024, 3071, -32, 0 });
}

// In double precision before they are rounded.
TEST(StoredValues, SmallDifferencesOfLargeNumbers)
{
  expectValues(storedOf(arrayOf(VTK_DOUBLE, { 1e12, 1e12 + 1, 1e12 + 0.25 })),
    { 1e12, 1e12 + 1, 1e12 + 0.25 });
  expectValues(storedOf(arrayOf(VTK_INT, { 2e9, 2e9 + 3, 2e9 + 1 })), { 2e9, 2e9 + 3, 2e9 + 1 });
}
} // namespace
