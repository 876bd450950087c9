// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tetmarch
{

std::string FormatTable(const std::vector<std::vector<std::string>>& rows)
{
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
  {
    for (std::size_t k = 0; k < widths.size(); ++k)
    {
      widths[k] = std::max(widths[k], row[k].size());
    }
  }
  std::string text;
  for (const auto& row : rows)
  {
    std::string line;
    for (std::size_t k = 0; k < widths.size(); ++k)
    {
      const std::string padding(widths[k] - row[k].size(), ' ');
      const bool last = k + 1 == widths.size();
      line += (k > 0 ? "  " : "") + (last ? row[k] : padding + row[k]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string FormatNumber(double number, int digits)
{
  if (std::isnan(number) || number == 0.0)
  {
    return number == 0.0 ? "0" : "-";
  }
  char digitsAndZeros[64];
  std::snprintf(digitsAndZeros, sizeof digitsAndZeros, "%#.*g", digits, number);
  std::string text = digitsAndZeros;
  if (text.back() == '.')
  {
    text.pop_back();
  }
  return text;
}

std::string FormatFixed(double number, int digits)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return text;
}

} // namespace tetmarch
