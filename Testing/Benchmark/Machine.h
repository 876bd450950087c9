// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the benchmark ran on, and when
 */
#ifndef tetmarch_bench_Machine_h
#define tetmarch_bench_Machine_h

#include <cstdint>
#include <string>

namespace tetmarch::bench
{
std::string currentDate();     // ISO 8601, UTC
std::string operatingSystem(); // its name, the kernel and the machine
std::string cpuModel();
int hardwareThreads(); // that this process may use
std::int64_t memoryBytes();
} // namespace tetmarch::bench

#endif
