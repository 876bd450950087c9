// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A cubic over [0, 1]: the scalar along a chord through a cell with trilinear interpolation
 */
#ifndef tetmarch_testing_Cubic_h
#define tetmarch_testing_Cubic_h

#include <array>
#include <vector>

namespace tetmarch::testing
{
class Cubic
{
public:
  /// From f0 at 0 to f1 at 1.
  static Cubic linear(double f0, double f1);
  /// By the values at 0, 1/3, 2/3 and 1.
  static Cubic through(const std::array<long double, 4>& values);

  double at(double u) const;

  /// Ascending, with 0 first and 1 last: between two of them the cubic rises, falls or is constant.
  std::vector<double> monotoneParts() const;

  /// Ascending, all u at which the cubic reaches a value or falls below it, to the last bit or two.
  /// Their number is odd if and only if one end is below the value and the other is not.
  std::vector<double> crossingsOf(double value) const;

  double least() const;
  double greatest() const;

private:
  std::array<double, 4> Powers{}; // of 1, u, u^2, u^3
  double Last = 0.0;              // at 1, exactly
};
} // namespace tetmarch::testing

#endif
