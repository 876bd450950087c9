// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Times and errors of images, as JSON and as a table in Markdown
 */
#ifndef tetmarch_bench_StructuredReport_h
#define tetmarch_bench_StructuredReport_h

#include "StructuredMeasurement.h"

namespace tetmarch::bench
{
nlohmann::ordered_json makeStructuredReport(
  const Options& options, const std::vector<StructuredRecord>& records);

/// Of what makeStructuredReport() made.
std::string makeStructuredMarkdown(const nlohmann::ordered_json& report);
} // namespace tetmarch::bench

#endif
