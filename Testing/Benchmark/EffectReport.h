// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What effects cost, as JSON and as a table in Markdown
 */
#ifndef tetmarch_bench_EffectReport_h
#define tetmarch_bench_EffectReport_h

#include "EffectMeasurement.h"

namespace tetmarch::bench
{
nlohmann::ordered_json makeEffectReport(
  const Options& options, const std::vector<EffectsRecord>& records);

/// Of what makeEffectReport() made.
std::string makeEffectMarkdown(const nlohmann::ordered_json& report);
} // namespace tetmarch::bench

#endif
