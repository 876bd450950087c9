// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What tables in Markdown are made of
 */
#ifndef tetmarch_bench_MarkdownText_h
#define tetmarch_bench_MarkdownText_h

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace tetmarch::bench
{
std::string format(const char* pattern, double value);

/// Three significant figures.
std::string seconds(double value);

/// Median and range of what summarizeSeconds() made; nothing of null.
std::string timesOf(const nlohmann::ordered_json& summary);

std::string row(const std::vector<std::string>& cells);

/// When, what and where a report is of.
std::string heading(const nlohmann::ordered_json& report);
} // namespace tetmarch::bench

#endif
