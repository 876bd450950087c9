// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The values of an array as 128 bits, to tell whether another array has the same.
#ifndef TetMarchCachingContentHash_h
#define TetMarchCachingContentHash_h

#include <array>
#include <cstdint>

class vtkDataArray;

namespace tetmarch
{

using ContentHash = std::array<std::uint64_t, 2>;

/**
 * Two hashes of 64 bits each of the array's type, its numbers of tuples and components and the
 * bits of its values, at the speed of memory. Equal arrays have the same hash on a machine,
 * whatever its number of threads. Different arrays have the same one with a probability of about
 * 2^-128. All 0 for nullptr.
 */
ContentHash contentHashOf(vtkDataArray* array);

} // namespace tetmarch

#endif
