// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/StoredScalar.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{

ScalarRange finiteRange(const std::vector<double>& values)
{
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  bool allFinite = true;
  for (double value : values)
  {
    if (std::isfinite(value))
    {
      low = std::min(low, value);
      high = std::max(high, value);
    }
    else
    {
      allFinite = false;
    }
  }
  if (low > high)
  {
    return { 0, 0, allFinite };
  }
  // Where low and high differ by more than the greatest double, their difference must not overflow.
  const double limit = 0.25 * std::numeric_limits<double>::max();
  const auto clamped = [limit](double x) { return std::min(std::max(x, -limit), limit); };
  return { clamped(low), clamped(high), allFinite };
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
