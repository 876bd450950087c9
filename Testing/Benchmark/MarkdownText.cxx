// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MarkdownText.h"

#include <cstdio>

namespace tetmarch::bench
{
using Json = nlohmann::ordered_json;

std::string format(const char* pattern, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), pattern, value);
  return text;
}

std::string seconds(double value)
{
  return format(value < 0.1    ? "%.4f"
                : value < 1.0  ? "%.3f"
                : value < 10.0 ? "%.2f"
                               : "%.1f",
    value);
}

std::string timesOf(const Json& summary)
{
  if (summary.is_null())
  {
    return {};
  }
  return seconds(summary["median_seconds"]) + " (" + seconds(summary["min_seconds"]) + "-" +
         seconds(summary["max_seconds"]) + ")";
}

std::string row(const std::vector<std::string>& cells)
{
  std::string line = "|";
  for (const std::string& text : cells)
  {
    line += " " + text + " |";
  }
  return line + "\n";
}

std::string heading(const Json& report)
{
  std::string text = report["date"].get<std::string>() + ", TetMarch " +
                     report["tetmarch_version"].get<std::string>();
  const Json& environment = report["environment"];
  if (!environment.is_null())
  {
    const Json& gl = environment["gl"];
    text += ", VTK " + environment["vtk_version"].get<std::string>() + ", " +
            gl["renderer"].get<std::string>() + " by " + gl["backend"].get<std::string>();
  }
  text += "; " + report["cpu"].get<std::string>() + ", " +
          std::to_string(report["cpu_threads"].get<int>()) + " threads; window " +
          std::to_string(report["size"][0].get<int>()) + " x " +
          std::to_string(report["size"][1].get<int>()) + ", " +
          std::to_string(report["rounds"].get<int>()) + " rounds of " +
          std::to_string(report["frames"].get<int>()) + " frames.\n";
  return text;
}
} // namespace tetmarch::bench
