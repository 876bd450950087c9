// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ticks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace tetmarch
{

namespace
{

constexpr double Rounding = 1e-9; // of a step

/// What a value may be off by, in steps, and more where a double has no such small parts of a step.
double GetSlack(double inSteps)
{
  return Rounding + 4.0 * std::numeric_limits<double>::epsilon() * std::abs(inSteps);
}

double GetFirst(double least, double step)
{
  return std::ceil(least / step - GetSlack(least / step));
}

double GetLast(double most, double step) { return std::floor(most / step + GetSlack(most / step)); }

/// The least step with which the range has no more ticks.
double FindStep(double least, double most, int atMost)
{
  const double ofEven = (most - least) / atMost;
  for (double power = std::pow(10.0, std::floor(std::log10(ofEven)));; power *= 10.0)
  {
    for (const double factor : { 1.0, 2.0, 5.0 })
    {
      const double step = factor * power;
      if (GetLast(most, step) - GetFirst(least, step) + 1.0 <= atMost)
      {
        return step;
      }
    }
  }
}

/// Significant digits with which multiples of a step are told apart. Ten show round numbers as they
/// are; doubles have no more than 17.
int CountDigits(double least, double most, double step)
{
  const double largest = std::max(std::abs(least), std::abs(most));
  const double digits =
    std::floor(std::log10(largest) + Rounding) - std::floor(std::log10(step) + Rounding) + 1.0;
  return static_cast<int>(std::min(std::max(digits, 10.0), 17.0));
}

} // namespace

std::vector<Tick> MakeTicks(double least, double most, int atMost)
{
  std::vector<Tick> ticks;
  if (!(least < most) || !std::isfinite(most - least) || atMost < 1)
  {
    return ticks;
  }
  const double step = FindStep(least, most, atMost);
  const double last = GetLast(most, step);
  const int digits = CountDigits(least, most, step);
  for (double i = GetFirst(least, step); i <= last; ++i)
  {
    const double value = i == 0.0 ? 0.0 : i * step; // no -0
    char label[32];
    std::snprintf(label, sizeof label, "%.*g", digits, value);
    ticks.push_back({ value, label });
  }
  return ticks;
}

std::vector<std::string> GetLabels(const std::vector<Tick>& ticks)
{
  std::vector<std::string> labels;
  for (const Tick& tick : ticks)
  {
    labels.push_back(tick.Label);
  }
  return labels;
}

} // namespace tetmarch
