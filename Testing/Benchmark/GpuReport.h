// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief All that can be measured of somebody's GPU, in one file that they can send
 */
#ifndef tetmarch_bench_GpuReport_h
#define tetmarch_bench_GpuReport_h

#include "Options.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>

namespace tetmarch::bench
{
/// What fails is told in the report, in words, and the rest goes on. The file is written after each
/// step, so that it has all that was found out if the machine hangs.
class GpuReport
{
public:
  explicit GpuReport(const Options& options);

  /// All but the times: the GL, and its pictures beside the CPU's. Tells on standard error how it
  /// goes.
  void measure();
  /// The report of the times, so far.
  void setBenchmark(const nlohmann::ordered_json& benchmark);

private:
  void attempt(const std::string& what, const std::function<void()>& step);
  void askForGL();
  void addParity(const std::string& dataset, const std::string& effect);
  void write() const;

  Options Asked; // in a small window
  nlohmann::ordered_json Report;
};
} // namespace tetmarch::bench

#endif
