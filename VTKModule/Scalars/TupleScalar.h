// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The drawn scalar of a tuple: one of its components, or the length of the vector.
#ifndef TetMarchScalarsTupleScalar_h
#define TetMarchScalarsTupleScalar_h

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{

struct TupleScalar
{
  bool Magnitude = false; // of all components
  int Component = 0;      // otherwise; the array has it
};

/** In double precision. The magnitude of finite components is finite: at most the largest double.
 * If a component is not finite, it is not finite. */
template <typename Tuple>
double magnitudeOf(const Tuple& tuple)
{
  double greatest = 0;
  double squares = 0;
  for (const auto component : tuple)
  {
    const auto value = static_cast<double>(component);
    if (!std::isfinite(value))
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    greatest = std::max(greatest, std::abs(value));
    squares += value * value;
  }
  // Squares of doubles beyond these bounds lose digits or are infinite.
  if (greatest == 0 || (greatest > 1e-140 && squares < 1e300))
  {
    return std::sqrt(squares);
  }
  squares = 0;
  for (const auto component : tuple)
  {
    const double share = static_cast<double>(component) / greatest;
    squares += share * share;
  }
  return std::min(greatest * std::sqrt(squares), std::numeric_limits<double>::max());
}

template <typename Tuple>
double scalarOf(const Tuple& tuple, const TupleScalar& scalar)
{
  return scalar.Magnitude ? magnitudeOf(tuple) : static_cast<double>(tuple[scalar.Component]);
}

} // namespace tetmarch

#endif
