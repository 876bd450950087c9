// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The input of a stage: as long as it compares equal, the stage need not run again.
#ifndef TetMarchCachingFingerprint_h
#define TetMarchCachingFingerprint_h

#include "vtkObject.h"

#include <cstdint>
#include <cstring>
#include <vector>

namespace tetmarch
{

using Fingerprint = std::vector<std::uintptr_t>;

/** Identity and time of change of an object, which may be null. */
inline void add(Fingerprint& fingerprint, vtkObject* object)
{
  fingerprint.push_back(reinterpret_cast<std::uintptr_t>(object));
  fingerprint.push_back(object ? static_cast<std::uintptr_t>(object->GetMTime()) : 0);
}

inline void add(Fingerprint& fingerprint, double value)
{
  std::uintptr_t bits = 0;
  std::memcpy(&bits, &value, sizeof(value));
  fingerprint.push_back(bits);
}

inline void add(Fingerprint& fingerprint, const Fingerprint& other)
{
  fingerprint.insert(fingerprint.end(), other.begin(), other.end());
}

/** Numbers, by their values as doubles. */
template <typename Values>
void addAll(Fingerprint& fingerprint, const Values& values)
{
  for (double value : values)
  {
    add(fingerprint, value);
  }
}

} // namespace tetmarch

#endif
