// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A float whose comparisons hold if one side is not a number
 *
 * A compiler of shaders may assume that there is no such value, and make !(a >= b) of a < b.
 */
#ifndef tetmarch_testing_TurnedNumber_h
#define tetmarch_testing_TurnedNumber_h

#include "Reference/Kernel.h"

#include <cmath>
#include <type_traits>

namespace tetmarch::testing
{
class TurnedNumber
{
public:
  TurnedNumber() = default;
  template <typename T, typename = std::enable_if_t<std::is_arithmetic_v<T>>>
  constexpr TurnedNumber(T value)
    : Value(static_cast<float>(value))
  {
  }
  template <typename T, typename = std::enable_if_t<std::is_arithmetic_v<T>>>
  constexpr explicit operator T() const
  {
    return static_cast<T>(this->Value);
  }

  using N = TurnedNumber;
  friend constexpr N operator-(N a) { return -a.Value; }
  friend constexpr N operator+(N a, N b) { return a.Value + b.Value; }
  friend constexpr N operator-(N a, N b) { return a.Value - b.Value; }
  friend constexpr N operator*(N a, N b) { return a.Value * b.Value; }
  friend constexpr N operator/(N a, N b) { return a.Value / b.Value; }
  friend constexpr bool operator<(N a, N b) { return !(a.Value >= b.Value); }
  friend constexpr bool operator>(N a, N b) { return !(a.Value <= b.Value); }
  friend constexpr bool operator<=(N a, N b) { return !(a.Value > b.Value); }
  friend constexpr bool operator>=(N a, N b) { return !(a.Value < b.Value); }
  friend constexpr bool operator==(N a, N b) { return !(a.Value != b.Value); }
  friend constexpr bool operator!=(N a, N b) { return a.Value != b.Value; }

  friend N floor(N a) { return std::floor(a.Value); }
  friend N sqrt(N a) { return std::sqrt(a.Value); }
  friend N exp(N a) { return std::exp(a.Value); }
  friend N log(N a) { return std::log(a.Value); }
  friend N abs(N a) { return std::abs(a.Value); }
  friend N fma(N a, N b, N c) { return std::fma(a.Value, b.Value, c.Value); }

private:
  float Value = 0;
};
} // namespace tetmarch::testing

namespace tetmarch
{
template <>
struct NumberRange<testing::TurnedNumber> : NumberRange<float>
{
};
} // namespace tetmarch

#endif
