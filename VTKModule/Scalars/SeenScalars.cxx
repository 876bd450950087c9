// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/SeenScalars.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{
namespace
{

// Relative rounding of stored scalars and their positions in a table.
constexpr double Rounding = 1e-6;

double roundingOf(double scalar) { return Rounding * std::min(scalar, 1 - scalar); }

} // namespace

SeenScalars::SeenScalars(const IntegralTable& table, const ScalarRange& range)
  : Scale(table.scale(range.width()))
  , Offset(table.offset(range.Low))
  , Before(table.Values.size() + 1)
{
  for (std::size_t i = 0; i < table.Values.size(); ++i)
  {
    this->Before[i + 1] = this->Before[i] + (table.Values[i][3] > 0 ? 1 : 0);
  }
}

// Between entries the extinction is linear: it is above 0 only within one entry of an entry with
// extinction. Scalars may be rounded, except 0 and 1, the ends of the range: these are exact, so
// that transparent ends stay transparent.
bool SeenScalars::between(double low, double high) const
{
  if (!(low <= high))
  {
    return false;
  }
  const double from = std::floor(this->positionOf(low - roundingOf(low)));
  const double to = std::ceil(this->positionOf(high + roundingOf(high)));
  return this->Before[this->entryOf(to) + 1] > this->Before[this->entryOf(from)];
}

std::size_t SeenScalars::entryOf(double position) const
{
  return static_cast<std::size_t>(
    std::clamp(position, 0.0, static_cast<double>(this->Before.size() - 2)));
}

bool isAnyBetween(const std::vector<float>& values, double low, double high)
{
  const auto first = std::lower_bound(values.begin(), values.end(), low - Rounding,
    [](float v, double limit) { return double(v) < limit; });
  return first != values.end() && double(*first) <= high + Rounding;
}

} // namespace tetmarch
