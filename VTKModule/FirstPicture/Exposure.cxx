// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/Exposure.h"

#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{

namespace
{

// Of at least one number.
double percentile(std::vector<double>& numbers, double fraction)
{
  const auto place =
    numbers.begin() + static_cast<std::ptrdiff_t>(fraction * double(numbers.size() - 1));
  std::nth_element(numbers.begin(), place, numbers.end());
  return *place;
}

void dropUpTo(double least, std::vector<double>& numbers)
{
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(),
                  [least](double number) { return !(number > least); }),
    numbers.end());
}

} // namespace

std::function<double(double)> extinctionOf(vtkPiecewiseFunction* opacity, bool structuredLaw)
{
  return [opacity, structuredLaw](double value)
  {
    const double a = opacity->GetValue(value);
    return structuredLaw ? -std::log1p(-std::min(a, 0.999)) : a;
  };
}

std::optional<Exposure> findExposure(
  const Crossings& crossings, const std::function<double(double)>& extinction)
{
  constexpr double shown = 0.05;
  const double half = std::log(2.0);
  const double most = -std::log1p(-0.97);
  std::vector<double> depths = crossings.opticalDepths(extinction);
  dropUpTo(0.0, depths);
  if (depths.empty())
  {
    return std::nullopt;
  }
  dropUpTo(shown * percentile(depths, 0.95), depths);
  const double ofMedian = percentile(depths, 0.5) / half;
  const double ofMost = percentile(depths, 0.95) / most;
  return Exposure{ std::max(ofMedian, ofMost), ofMost <= ofMedian };
}

double exposedUnitDistance(
  const Crossings& crossings, const std::function<double(double)>& extinction)
{
  if (const std::optional<Exposure> exposure = findExposure(crossings, extinction))
  {
    return exposure->UnitDistance;
  }
  const std::vector<double> lengths = crossings.lengths();
  const double longest = lengths.empty() ? 0.0 : *std::max_element(lengths.begin(), lengths.end());
  return longest > 0 ? longest : 1.0;
}

double exposeFirstOpacity(const ValueStatistics& statistics, const Crossings& crossings,
  bool structuredLaw, vtkPiecewiseFunction* opacity)
{
  const double most = structuredLaw ? 0.95 : 1.0;
  for (const double exponent : { 2.0, 1.5, 1.0, 0.75, 0.5 })
  {
    makeFirstOpacity(statistics, exponent, most, opacity);
    const auto exposure = findExposure(crossings, extinctionOf(opacity, structuredLaw));
    if (exposure && exposure->Even)
    {
      return exposure->UnitDistance;
    }
  }
  return exposedUnitDistance(crossings, extinctionOf(opacity, structuredLaw));
}

} // namespace tetmarch
