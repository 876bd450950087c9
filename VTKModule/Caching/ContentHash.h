// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A 128-bit hash of the values of an array, to detect equal arrays.
#ifndef TetMarchCachingContentHash_h
#define TetMarchCachingContentHash_h

#include <array>
#include <cstdint>

class vtkDataArray;

namespace tetmarch
{

using ContentHash = std::array<std::uint64_t, 2>;

/**
 * Two hashes of 64 bits each of the array's type, its numbers of tuples and components and the bits
 * of its values, at the speed of memory. On one machine equal arrays have the same hash for any
 * number of threads. Different arrays have the same one with a probability of about 2^-128. All 0
 * for nullptr.
 */
ContentHash contentHashOf(vtkDataArray* array);

} // namespace tetmarch

#endif
