// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text, with enough digits to distinguish the ends of a range: 101324.9 to 101325.4.
#ifndef TetMarchFirstPictureRangeText_h
#define TetMarchFirstPictureRangeText_h

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

namespace tetmarch
{

// With the given number of significant digits, without trailing zeros. Integers of up to ten digits
// are complete.
inline std::string numberText(double number, int digits)
{
  constexpr double longest = 1e10;
  const bool inFull = number == std::floor(number) && std::abs(number) < longest;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(inFull ? std::max(digits, 10) : digits);
  text << (number == 0.0 ? 0.0 : number); // no -0
  return text.str();
}

// The number of significant digits, 6 to 17, with which the rounding of a number is at most the
// error.
inline int digitsWithin(double number, double error)
{
  const double digits =
    std::ceil(std::floor(std::log10(std::abs(number))) + 1.0 - std::log10(2.0 * error));
  return digits > 6.0 ? static_cast<int>(std::min(digits, 17.0)) : 6;
}

// The two ends, rounded by at most a hundredth of their difference.
inline std::array<std::string, 2> rangeText(double low, double high)
{
  constexpr int ofFloats = 7;
  if (low == high)
  {
    return { { numberText(low, ofFloats), numberText(high, ofFloats) } };
  }
  const double error = std::max((high - low) / 100.0, std::numeric_limits<double>::denorm_min());
  return { { numberText(low, digitsWithin(low, error)),
    numberText(high, digitsWithin(high, error)) } };
}

} // namespace tetmarch

#endif
