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

// Entropy in bits of the opacities of covered pixels, in 16 bins.
double entropyOf(
  const std::vector<double>& depths, const std::vector<double>& lengths, double unitDistance)
{
  constexpr int bins = 16;
  std::array<double, bins> counts{};
  double total = 0;
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    if (lengths[i] > 0)
    {
      const double opacity = -std::expm1(-depths[i] / unitDistance);
      const bool shown = opacity > 0; // and a number
      counts[shown ? static_cast<int>(std::min(opacity * bins, bins - 1.0)) : 0] += 1;
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

// As findExposure(), of optical depths at a unit distance of 1.
std::optional<double> exposureOf(std::vector<double> depths)
{
  constexpr double shown = 0.05;
  const double half = std::log(2.0);
  const double most = -std::log1p(-0.97);
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

// As exposedUnitDistance(), of optical depths and of lengths.
double unitDistanceOf(std::vector<double> depths, const std::vector<double>& lengths)
{
  if (const std::optional<double> exposed = exposureOf(std::move(depths)))
  {
    return *exposed;
  }
  const double longest = lengths.empty() ? 0.0 : *std::max_element(lengths.begin(), lengths.end());
  return longest > 0 ? longest : 1.0;
}

// The opacity of the background. Both opacity laws agree for small values.
double veilOf(std::vector<double> lengths, double unitDistance)
{
  constexpr double most = 0.05;
  constexpr double depth = 0.128; // of an opacity of 0.12
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
  return exposureOf(crossings.opticalDepths(extinction));
}

double exposedUnitDistance(
  const Crossings& crossings, const std::function<double(double)>& extinction)
{
  return unitDistanceOf(crossings.opticalDepths(extinction), crossings.lengths());
}

double exposeFirstOpacity(const ValueStatistics& statistics, const Crossings& crossings,
  const ExposureOptions& options, vtkPiecewiseFunction* opacity)
{
  const bool law = options.StructuredLaw;
  OpacityShape shape;
  shape.Most = law ? 0.95 : 1.0;
  const std::vector<double> lengths = crossings.lengths();
  double unitDistance = 0;
  double most = -1;
  for (const double exponent : { 2.0, 1.5, 1.0, 0.75, 0.5 })
  {
    OpacityShape tried = shape;
    tried.Exponent = exponent;
    makeFirstOpacity(statistics, tried, opacity);
    const std::vector<double> depths = crossings.opticalDepths(extinctionOf(opacity, law));
    const double distance = unitDistanceOf(depths, lengths);
    const double entropy = entropyOf(depths, lengths, distance);
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
    shape.Least = veilOf(lengths, unitDistance);
    makeFirstOpacity(statistics, shape, opacity);
  }
  return unitDistance;
}

} // namespace tetmarch
