// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/Exposure.h"

#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <array>
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

// In bits, of the opacities of the pixels before the data, in 16 bins.
double entropyOf(
  const Crossings& crossings, const std::function<double(double)>& extinction, double unitDistance)
{
  constexpr int bins = 16;
  std::array<double, bins> counts{};
  double total = 0;
  const std::vector<double> depths = crossings.opticalDepths(extinction);
  const std::vector<double> lengths = crossings.lengths();
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    if (lengths[i] > 0)
    {
      const double opacity = -std::expm1(-depths[i] / unitDistance);
      counts[std::min(bins - 1, static_cast<int>(opacity * bins))] += 1;
      total += 1;
    }
  }
  double bits = 0;
  for (const double count : counts)
  {
    bits -= count > 0 ? count / total * std::log2(count / total) : 0;
  }
  return bits;
}

// The opacity of the background. Both laws of opacity agree on what is as small.
double veilOf(const Crossings& crossings, double unitDistance)
{
  constexpr double most = 0.05;
  constexpr double depth = 0.128; // of an opacity of 0.12
  std::vector<double> lengths = crossings.lengths();
  dropUpTo(0.0, lengths);
  return lengths.empty() ? 0.0 : std::min(most, depth * unitDistance / percentile(lengths, 0.5));
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

std::optional<double> findExposure(
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
  return std::max(ofMedian, ofMost);
}

double exposedUnitDistance(
  const Crossings& crossings, const std::function<double(double)>& extinction)
{
  if (const std::optional<double> exposed = findExposure(crossings, extinction))
  {
    return *exposed;
  }
  const std::vector<double> lengths = crossings.lengths();
  const double longest = lengths.empty() ? 0.0 : *std::max_element(lengths.begin(), lengths.end());
  return longest > 0 ? longest : 1.0;
}

double exposeFirstOpacity(const ValueStatistics& statistics, const Crossings& crossings,
  const ExposureOptions& options, vtkPiecewiseFunction* opacity)
{
  const bool law = options.StructuredLaw;
  OpacityShape shape;
  shape.Most = law ? 0.95 : 1.0;
  double unitDistance = 0;
  double most = -1;
  for (const double exponent : { 2.0, 1.5, 1.0, 0.75, 0.5 })
  {
    OpacityShape tried = shape;
    tried.Exponent = exponent;
    makeFirstOpacity(statistics, tried, opacity);
    const auto extinction = extinctionOf(opacity, law);
    const double distance = exposedUnitDistance(crossings, extinction);
    const double entropy = entropyOf(crossings, extinction, distance);
    if (entropy > most)
    {
      most = entropy;
      shape = tried;
      unitDistance = distance;
    }
  }
  makeFirstOpacity(statistics, shape, opacity);
  if (options.Veil)
  {
    shape.Least = veilOf(crossings, unitDistance);
    makeFirstOpacity(statistics, shape, opacity);
  }
  return unitDistance;
}

} // namespace tetmarch
