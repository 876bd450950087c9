// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The figures of a run, as JSON and as a table in Markdown
 */
#ifndef tetmarch_bench_Report_h
#define tetmarch_bench_Report_h

#include "Measurement.h"

namespace tetmarch::bench
{
/// What was run, when and where, with no environment and no datasets yet.
nlohmann::ordered_json describeRun(const Options& options);

/// Median, least and most with all figures; null if there are none.
nlohmann::ordered_json summarizeSeconds(const std::vector<double>& seconds);

nlohmann::ordered_json makeReport(
  const Options& options, const std::vector<DatasetRecord>& records);

/// Of what makeReport() made.
std::string makeMarkdown(const nlohmann::ordered_json& report);
} // namespace tetmarch::bench

#endif
