// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Numbers as the shortest text that is read back as the same number.
 */
#ifndef tetmarch_NumberText_h
#define tetmarch_NumberText_h

#include <array>
#include <charconv>
#include <string>

namespace tetmarch
{

inline std::string ToText(double number)
{
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number);
  return { text.data(), end.ptr };
}

/// With commas between them.
template <typename Numbers>
std::string ToList(const Numbers& numbers)
{
  std::string text;
  for (const auto number : numbers)
  {
    text += (text.empty() ? "" : ",") + ToText(static_cast<double>(number));
  }
  return text;
}

} // namespace tetmarch

#endif
