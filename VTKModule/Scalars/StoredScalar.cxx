// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/StoredScalar.h"

namespace tetmarch
{

void FiniteRange::add(const FiniteRange& other)
{
  this->Low = std::min(this->Low, other.Low);
  this->High = std::max(this->High, other.High);
  this->AllFinite = this->AllFinite && other.AllFinite;
}

ScalarRange FiniteRange::range() const
{
  if (this->Low > this->High)
  {
    return { 0, 0, this->AllFinite, this->AllFinite };
  }
  // If low and high differ by more than the largest double, their difference must not overflow.
  const double limit = 0.25 * std::numeric_limits<double>::max();
  const auto clamped = [limit](double x) { return std::min(std::max(x, -limit), limit); };
  return { clamped(this->Low), clamped(this->High), this->AllFinite };
}

FiniteRange rangeOf(const std::vector<double>& values)
{
  FiniteRange range;
  for (double value : values)
  {
    range.add(value);
  }
  return range;
}

float storedScalar(double value, const ScalarRange& range)
{
  if (!std::isfinite(value))
  {
    return UndrawnScalar;
  }
  const double share = (value - range.Low) / range.width();
  return static_cast<float>(std::min(std::max(share, 0.0), 1.0));
}

} // namespace tetmarch
