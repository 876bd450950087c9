// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What is stored of an array as values of a lattice
 */
#ifndef tetmarch_testing_ValuesOfArrays_h
#define tetmarch_testing_ValuesOfArrays_h

#include "Structured/StoredValues.h"

#include "StoredScalars.h"

#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace tetmarch::testing
{
/// The first values that are drawn.
inline StoredValues storedOf(vtkDataArray* array, const TupleScalar& scalar = {})
{
  return std::move(storeValues({ array, false, ComponentMix::Single, scalar }).front());
}

inline ValueType expectedType(int type)
{
  const int bytes = vtkDataArray::GetDataTypeSize(type);
  return type == VTK_BIT || bytes == 1 ? ValueType::UInt8
         : bytes == 2                  ? ValueType::UInt16
                                       : ValueType::Float32;
}

/// Each value comes back from what is stored to a rounding of the widths, and the ends of the range
/// are 0 and 1.
inline void expectValues(
  const StoredValues& stored, const std::vector<double>& values, double rounding = 1.2e-7)
{
  ASSERT_EQ(stored.Count, values.size());
  EXPECT_EQ(stored.bytes(), values.size() * StoredValues::sizeOf(stored.Type));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double exact = (values[i] - stored.Range.Low) / stored.Range.width();
    EXPECT_NEAR(double(stored.scalar(i)), exact, rounding) << i;
    if (stored.Type == ValueType::Float32)
    {
      EXPECT_EQ(stored.scalar(i), static_cast<float>(exact)) << i;
    }
  }
}
} // namespace tetmarch::testing

#endif
