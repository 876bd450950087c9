// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cubic.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
Cubic Cubic::linear(double f0, double f1)
{
  Cubic line;
  line.Powers = { { f0, f1 - f0, 0.0, 0.0 } };
  line.Last = f1;
  return line;
}

Cubic Cubic::through(const std::array<long double, 4>& values)
{
  // Newton's divided differences at steps of a third, multiplied out.
  const long double first = values[1] - values[0];
  const long double second = values[2] - 2.0L * values[1] + values[0];
  const long double third = values[3] - 3.0L * values[2] + 3.0L * values[1] - values[0];
  Cubic cubic;
  cubic.Powers = { { static_cast<double>(values[0]),
    static_cast<double>(3.0L * first - 1.5L * second + third),
    static_cast<double>(4.5L * (second - third)), static_cast<double>(4.5L * third) } };
  cubic.Last = static_cast<double>(values[3]);
  return cubic;
}

double Cubic::at(double u) const
{
  const auto& c = this->Powers;
  return u == 1.0 ? this->Last : c[0] + u * (c[1] + u * (c[2] + u * c[3]));
}

std::vector<double> Cubic::monotoneParts() const
{
  std::vector<double> parts = { 0.0 };
  // The roots of the slope a u^2 + 2 b u + c, without cancellation (Press et al., "Numerical
  // Recipes", section 5.6).
  const double a = 3.0 * this->Powers[3];
  const double b = this->Powers[2];
  const double c = this->Powers[1];
  const double discriminant = b * b - a * c;
  if (discriminant > 0.0)
  {
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    for (const double u : { q / a, c / q })
    {
      if (u > 0.0 && u < 1.0)
      {
        parts.push_back(u);
      }
    }
  }
  std::sort(parts.begin(), parts.end());
  parts.push_back(1.0);
  return parts;
}

std::vector<double> Cubic::crossingsOf(double value) const
{
  std::vector<double> crossings;
  const std::vector<double> parts = this->monotoneParts();
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    const bool below = this->at(parts[i - 1]) < value;
    if (below == (this->at(parts[i]) < value))
    {
      continue;
    }
    if (this->Powers[2] == 0.0 && this->Powers[3] == 0.0)
    {
      return { std::clamp((value - this->Powers[0]) / this->Powers[1], 0.0, 1.0) };
    }
    // Bisection until no double is left between the two.
    double before = parts[i - 1];
    double after = parts[i];
    for (double middle = 0.5 * (before + after); middle > before && middle < after;
         middle = 0.5 * (before + after))
    {
      ((this->at(middle) < value) == below ? before : after) = middle;
    }
    crossings.push_back(after);
  }
  return crossings;
}

double Cubic::least() const
{
  double least = this->Last;
  for (const double u : this->monotoneParts())
  {
    least = std::min(least, this->at(u));
  }
  return least;
}

double Cubic::greatest() const
{
  double greatest = this->Last;
  for (const double u : this->monotoneParts())
  {
    greatest = std::max(greatest, this->at(u));
  }
  return greatest;
}
} // namespace tetmarch::testing
