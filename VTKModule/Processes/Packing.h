// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Serialization of numbers.
#ifndef TetMarchProcessesPacking_h
#define TetMarchProcessesPacking_h

#include "Processes/Group.h"

#include <cstddef>
#include <cstring>
#include <vector>

namespace tetmarch
{

class Packer
{
public:
  template <typename T>
  void add(const T* values, std::size_t count)
  {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values);
    this->Packed.insert(this->Packed.end(), bytes, bytes + count * sizeof(T));
  }
  Bytes Packed;
};

/** Reads the packed values in the same order. Throws a GroupFailure at the end of the bytes. */
class Unpacker
{
public:
  explicit Unpacker(const Bytes& bytes)
    : Packed(bytes)
  {
  }
  template <typename T>
  void take(T* values, std::size_t count)
  {
    this->check<T>(count);
    if (count > 0)
    {
      std::memcpy(values, this->Packed.data() + this->At, count * sizeof(T));
    }
    this->At += count * sizeof(T);
  }
  /** Reads the number of values stated by another process; memory is allocated only if the bytes
   * exist. */
  template <typename T>
  std::vector<T> takeVector(std::size_t count)
  {
    this->check<T>(count);
    std::vector<T> values(count);
    this->take(values.data(), count);
    return values;
  }

private:
  template <typename T>
  void check(std::size_t count) const
  {
    if (count > (this->Packed.size() - this->At) / sizeof(T))
    {
      throw GroupFailure("What a process sent ends too early.");
    }
  }

  const Bytes& Packed;
  std::size_t At = 0;
};

} // namespace tetmarch

#endif
