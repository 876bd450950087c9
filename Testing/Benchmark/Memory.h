// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Memory of this process, as Linux counts it
 */
#ifndef tetmarch_bench_Memory_h
#define tetmarch_bench_Memory_h

#include <cstdint>

namespace tetmarch::bench
{
/// Bytes that are resident now.
std::int64_t residentBytes();

/// The most bytes that were resident since the process started, or since forgetPeak().
std::int64_t peakResidentBytes();
void forgetPeak();
} // namespace tetmarch::bench

#endif
