// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Numbers from text, all of the text or nothing.
 */
#ifndef tetmarch_Numbers_h
#define tetmarch_Numbers_h

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace tetmarch
{

template <typename Number>
std::optional<Number> ParseWhole(const std::string& text)
{
  Number number{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc() && result.ptr == end ? std::optional<Number>(number)
                                                       : std::nullopt;
}

inline std::optional<int> ParseInteger(const std::string& text) { return ParseWhole<int>(text); }

/// A finite number.
inline std::optional<double> ParseNumber(const std::string& text)
{
  const auto number = ParseWhole<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

inline std::optional<std::vector<double>> ParseNumbers(const std::string& text, char separator)
{
  std::vector<double> numbers;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 1)
  {
    end = text.find(separator, begin);
    const auto number =
      ParseNumber(text.substr(begin, end == std::string::npos ? end : end - begin));
    if (!number)
    {
      return std::nullopt;
    }
    numbers.push_back(*number);
  }
  return numbers;
}

} // namespace tetmarch

#endif
