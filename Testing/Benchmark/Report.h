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
nlohmann::ordered_json makeReport(
  const Options& options, const std::vector<DatasetRecord>& records);

/// Of what makeReport() made.
std::string makeMarkdown(const nlohmann::ordered_json& report);
} // namespace tetmarch::bench

#endif
