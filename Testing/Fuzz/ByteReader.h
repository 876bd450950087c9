// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads bytes one after the other, as numbers and as ids of points and cells
 */
#ifndef tetmarch_testing_ByteReader_h
#define tetmarch_testing_ByteReader_h

#include "GridCode.h"

#include "vtkType.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

namespace tetmarch::testing
{
inline const double WildNumbers[] = { std::nan(""), std::numeric_limits<double>::infinity(),
  -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::max(),
  std::numeric_limits<double>::lowest(), 1e300, 1e154, 1e101, 1e38, 1e-38, 1e-160,
  std::numeric_limits<double>::min(), std::numeric_limits<double>::denorm_min(), -0.0, 0.1,
  1.0 / 3.0 };

constexpr vtkIdType WildIds[] = { -1, -2, VTK_ID_MIN, VTK_ID_MAX, VTK_ID_MAX - 1, 0x7fffffff,
  0x80000000, 0xffffffff, 0x100000000, 0x3fffffffffffffff };

class ByteReader
{
public:
  explicit ByteReader(const Bytes& bytes)
    : Data(bytes)
  {
  }

  /// The next byte; 0 when there are no more.
  int byte() { return this->At < this->Data.size() ? this->Data[this->At++] : 0; }
  int signedByte() { return static_cast<std::int8_t>(this->byte()); }
  int word() { return this->byte() | this->byte() << 8; }
  double number()
  {
    const int value = this->signedByte();
    return value == -128 ? WildNumbers[this->byte() % std::size(WildNumbers)] : value;
  }
  vtkIdType id()
  {
    const int value = this->signedByte();
    return value == -128 ? WildIds[this->byte() % std::size(WildIds)] : value;
  }
  bool isAtEnd() const { return this->At >= this->Data.size(); }

private:
  const Bytes& Data;
  std::size_t At = 0;
};
} // namespace tetmarch::testing

#endif
