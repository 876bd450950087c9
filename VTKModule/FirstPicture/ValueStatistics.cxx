// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/ValueStatistics.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace tetmarch
{

namespace
{

// Differences of values up to this one, and sums of a few, don't overflow. The mapper clamps the
// ends of its range likewise (Scalars/StoredScalar.h).
constexpr double MostValue = 0.25 * std::numeric_limits<double>::max();
// Values that differ by less are treated as equal: a fraction of such a difference may be denormal.
constexpr double LeastDifference = 1e-290;

double clamped(double value) { return std::clamp(value, -MostValue, MostValue); }

bool differ(const std::array<double, 2>& range) { return range[1] - range[0] > LeastDifference; }

double weightOf(const Sample& sample)
{
  const double length = std::cbrt(sample.Volume);
  return length * length;
}

double sumOfWeights(const std::vector<Sample>& samples)
{
  double sum = 0.0;
  for (const Sample& sample : samples)
  {
    sum += weightOf(sample);
  }
  return sum;
}

/// The samples must be sorted by value.
double percentileOf(const std::vector<Sample>& samples, double total, double fraction)
{
  double sum = 0.0;
  for (const Sample& sample : samples)
  {
    sum += weightOf(sample);
    if (sum >= fraction * total)
    {
      return sample.Value;
    }
  }
  return samples.back().Value;
}

std::array<double, 2> rangeOfSamples(const std::vector<Sample>& samples, double total)
{
  std::array<double, 2> range = { { percentileOf(samples, total, 0.02),
    percentileOf(samples, total, 0.98) } };
  if (!differ(range))
  {
    range = { { samples.front().Value, samples.back().Value } };
  }
  if (!differ(range))
  {
    const double half = 0.5 * std::max(1.0, std::abs(range[0]));
    range = { { range[0] - half, range[0] + half } };
  }
  return range;
}

struct Mode
{
  double Value; // the middle of the fullest of 256 bins of a range
  double Share; // of the weight that lies within a 50th of the range around it
};

bool isNear(const Sample& sample, double value, const std::array<double, 2>& range)
{
  return std::abs(sample.Value - value) <= 0.02 * (range[1] - range[0]);
}

Mode findMode(const std::vector<Sample>& samples, double total, const std::array<double, 2>& range)
{
  constexpr int bins = 256;
  std::array<double, bins> sums{};
  const double width = (range[1] - range[0]) / bins;
  for (const Sample& sample : samples)
  {
    if (sample.Value >= range[0] && sample.Value <= range[1])
    {
      sums[std::min(bins - 1, static_cast<int>((sample.Value - range[0]) / width))] +=
        weightOf(sample);
    }
  }
  const auto fullest = std::max_element(sums.begin(), sums.end()) - sums.begin();
  const double mode = range[0] + (static_cast<double>(fullest) + 0.5) * width;
  double near = 0.0;
  for (const Sample& sample : samples)
  {
    near += isNear(sample, mode, range) ? weightOf(sample) : 0.0;
  }
  return { mode, near / total };
}

double findBackground(
  const std::vector<Sample>& samples, double total, const std::array<double, 2>& range)
{
  if (!differ(range))
  {
    return range[0];
  }
  const Mode mode = findMode(samples, total, range);
  return mode.Share >= 0.1 ? mode.Value : range[0];
}

std::array<double, 2> rangeOfLattice(const std::vector<Sample>& samples, double total)
{
  const std::array<double, 2> all = { { samples.front().Value, samples.back().Value } };
  if (!differ(all))
  {
    return rangeOfSamples(samples, total);
  }
  const Mode mode = findMode(samples, total, all);
  std::vector<Sample> rest;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(rest),
    [&](const Sample& sample) { return !isNear(sample, mode.Value, all); });
  if (mode.Share < 0.5 || rest.empty())
  {
    return rangeOfSamples(samples, total);
  }
  const std::array<double, 2> range = rangeOfSamples(rest, sumOfWeights(rest));
  return { { std::min(range[0], mode.Value), std::max(range[1], mode.Value) } };
}

} // namespace

ValueStatistics computeStatistics(
  std::vector<Sample> samples, const std::optional<std::array<double, 2>>& range, bool lattice)
{
  ValueStatistics statistics;
  if (range)
  {
    statistics.Range = { { clamped((*range)[0]), clamped((*range)[1]) } };
    statistics.Background = statistics.Range[0];
  }
  if (!samples.empty())
  {
    for (Sample& sample : samples)
    {
      sample.Value = clamped(sample.Value);
    }
    std::sort(samples.begin(), samples.end(),
      [](const Sample& a, const Sample& b) { return a.Value < b.Value; });
    const double total = sumOfWeights(samples);
    statistics.Range = range     ? statistics.Range
                       : lattice ? rangeOfLattice(samples, total)
                                 : rangeOfSamples(samples, total);
    const bool varies = differ({ { samples.front().Value, samples.back().Value } });
    statistics.Background =
      varies ? findBackground(samples, total, statistics.Range) : statistics.Range[0];
  }
  return statistics;
}

} // namespace tetmarch
