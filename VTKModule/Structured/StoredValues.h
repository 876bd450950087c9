// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The values of a lattice in the type in which they are stored on the GPU.
#ifndef TetMarchStructuredStoredValues_h
#define TetMarchStructuredStoredValues_h

#include "Scalars/DrawnScalars.h"
#include "Scalars/StoredScalar.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetmarch
{

/** The size of a value in bytes: unsigned integers, or float. */
enum class ValueType : unsigned char
{
  UInt8,
  UInt16,
  Float32
};

/**
 * One scalar for each value of a lattice. Integers of 8 and 16 bits are kept: an array of one
 * unsigned component is not copied, unless its range is narrow and so far from 0 that Scale u +
 * Offset would lose digits; for others the difference to their minimum is stored. All other types
 * are normalised to 0..1 in double precision and rounded to float; values that are not finite
 * become UndrawnScalar.
 *
 * The GPU reads an unsigned integer of n bits as u = value / (2^n - 1), a float as u = value. The
 * stored scalar is Scale u + Offset: 0 at Range.Low and 1 at Range.High.
 */
struct StoredValues
{
  ValueType Type = ValueType::Float32;
  std::size_t Count = 0;
  const void* Data = nullptr; // Count values; owned by one of the following members
  float Scale = 1;
  float Offset = 0;
  ScalarRange Range; // of the data

  vtkSmartPointer<vtkDataArray> Borrowed;
  std::vector<std::uint8_t> Bytes;
  std::vector<std::uint16_t> Words;
  std::vector<float> Floats;

  StoredValues() = default;
  StoredValues(const StoredValues&) = delete;
  StoredValues& operator=(const StoredValues&) = delete;
  StoredValues(StoredValues&&) = default;
  StoredValues& operator=(StoredValues&&) = default;

  static constexpr std::size_t sizeOf(ValueType type)
  {
    return type == ValueType::UInt8 ? 1 : type == ValueType::UInt16 ? 2 : 4;
  }
  std::size_t bytes() const { return this->Count * sizeOf(this->Type); }

  /** The value read by the GPU, before Scale and Offset. */
  template <typename Real>
  Real read(std::size_t i) const
  {
    switch (this->Type)
    {
      case ValueType::UInt8:
        return Real(static_cast<const std::uint8_t*>(this->Data)[i]) / Real(255);
      case ValueType::UInt16:
        return Real(static_cast<const std::uint16_t*>(this->Data)[i]) / Real(65535);
      default:
        return Real(static_cast<const float*>(this->Data)[i]);
    }
  }
  /** The stored scalar, or UndrawnScalar. */
  float scalar(std::size_t i) const
  {
    const float u = this->read<float>(i);
    return this->Type == ValueType::Float32 ? u : u * this->Scale + this->Offset;
  }
};

/**
 * The values of the drawn components: the first scalar, then the extra ones. The array has one
 * tuple for each value, in VTK's order. If the first or an extra value is not finite, the first
 * one is UndrawnScalar, its range is not AllFinite, and an extra one is 0.
 */
std::vector<StoredValues> storeValues(const DrawnScalars& drawn);

} // namespace tetmarch

#endif
