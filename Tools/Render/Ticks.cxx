// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ticks.h"

#include <cmath>
#include <cstdio>

namespace tetmarch
{

namespace
{

constexpr double Rounding = 1e-9; // of a step

/// The least step with which the range has no more ticks.
double FindStep(double least, double most, int atMost)
{
  const double ofEven = (most - least) / atMost;
  for (double power = std::pow(10.0, std::floor(std::log10(ofEven)));; power *= 10.0)
  {
    for (const double factor : { 1.0, 2.0, 5.0 })
    {
      const double step = factor * power;
      const double first = std::ceil(least / step - Rounding);
      const double last = std::floor(most / step + Rounding);
      if (last - first + 1.0 <= atMost)
      {
        return step;
      }
    }
  }
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
  const double first = std::ceil(least / step - Rounding);
  const double last = std::floor(most / step + Rounding);
  for (double i = first; i <= last; ++i)
  {
    const double value = i == 0.0 ? 0.0 : i * step; // no -0
    char label[32];
    std::snprintf(label, sizeof label, "%.10g", value);
    ticks.push_back({ value, label });
  }
  return ticks;
}

} // namespace tetmarch
