// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DefaultTransferFunction.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
using tetmarch::Sample;

double GetWeight(const Sample& sample) { return std::cbrt(sample.Volume * sample.Volume); }

double SumWeights(const std::vector<Sample>& samples)
{
  double sum = 0.0;
  for (const Sample& sample : samples)
  {
    sum += GetWeight(sample);
  }
  return sum;
}

/// The samples must be sorted by value.
double GetPercentile(const std::vector<Sample>& samples, double total, double fraction)
{
  double sum = 0.0;
  for (const Sample& sample : samples)
  {
    sum += GetWeight(sample);
    if (sum >= fraction * total)
    {
      return sample.Value;
    }
  }
  return samples.back().Value;
}

std::array<double, 2> ComputeRange(const std::vector<Sample>& samples, double total)
{
  std::array<double, 2> range = { { GetPercentile(samples, total, 0.02),
    GetPercentile(samples, total, 0.98) } };
  if (!(range[0] < range[1]))
  {
    range = { { samples.front().Value, samples.back().Value } };
  }
  if (!(range[0] < range[1]))
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

bool IsNear(const Sample& sample, double value, const std::array<double, 2>& range)
{
  return std::abs(sample.Value - value) <= 0.02 * (range[1] - range[0]);
}

Mode FindMode(const std::vector<Sample>& samples, double total, const std::array<double, 2>& range)
{
  constexpr int bins = 256;
  std::array<double, bins> sums{};
  const double width = (range[1] - range[0]) / bins;
  for (const Sample& sample : samples)
  {
    if (sample.Value >= range[0] && sample.Value <= range[1])
    {
      sums[std::min(bins - 1, static_cast<int>((sample.Value - range[0]) / width))] +=
        GetWeight(sample);
    }
  }
  const auto fullest = std::max_element(sums.begin(), sums.end()) - sums.begin();
  const double mode = range[0] + (static_cast<double>(fullest) + 0.5) * width;
  double near = 0.0;
  for (const Sample& sample : samples)
  {
    near += IsNear(sample, mode, range) ? GetWeight(sample) : 0.0;
  }
  return { mode, near / total };
}

double FindBackground(
  const std::vector<Sample>& samples, double total, const std::array<double, 2>& range)
{
  const Mode mode = FindMode(samples, total, range);
  return mode.Share >= 0.1 ? mode.Value : range[0];
}

std::array<double, 2> ComputeRangeOfImage(const std::vector<Sample>& samples, double total)
{
  const std::array<double, 2> all = { { samples.front().Value, samples.back().Value } };
  if (!(all[0] < all[1]))
  {
    return ComputeRange(samples, total);
  }
  const Mode mode = FindMode(samples, total, all);
  std::vector<Sample> rest;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(rest),
    [&](const Sample& sample) { return !IsNear(sample, mode.Value, all); });
  if (mode.Share < 0.5 || rest.empty())
  {
    return ComputeRange(samples, total);
  }
  const std::array<double, 2> range = ComputeRange(rest, SumWeights(rest));
  return { { std::min(range[0], mode.Value), std::max(range[1], mode.Value) } };
}

void AddSequentialColors(vtkColorTransferFunction* color, const std::array<double, 2>& range)
{
  // Samples of the map "plasma" by N. Smith and S. van der Walt (2015, CC0).
  static const double plasma[][3] = { { 0.050, 0.030, 0.528 }, { 0.294, 0.012, 0.631 },
    { 0.492, 0.012, 0.658 }, { 0.658, 0.134, 0.588 }, { 0.798, 0.280, 0.470 },
    { 0.899, 0.424, 0.363 }, { 0.973, 0.580, 0.254 }, { 0.994, 0.772, 0.155 },
    { 0.940, 0.975, 0.131 } };
  constexpr int last = 8;
  color->SetColorSpaceToLab();
  for (int i = 0; i <= last; ++i)
  {
    color->AddRGBPoint(
      range[0] + (range[1] - range[0]) * i / last, plasma[i][0], plasma[i][1], plasma[i][2]);
  }
}

void AddDivergingColors(vtkColorTransferFunction* color, double centre, double reach)
{
  // K. Moreland, Diverging Color Maps for Scientific Visualization, 2009.
  color->SetColorSpaceToDiverging();
  color->AddRGBPoint(centre - reach, 0.231, 0.298, 0.753);
  color->AddRGBPoint(centre, 0.865, 0.865, 0.865);
  color->AddRGBPoint(centre + reach, 0.706, 0.016, 0.150);
}
} // namespace

namespace tetmarch
{

ValueStatistics ComputeStatistics(
  std::vector<Sample> samples, const std::optional<std::array<double, 2>>& range, DataKind kind)
{
  ValueStatistics statistics;
  if (range)
  {
    statistics.Range = *range;
    statistics.Background = (*range)[0];
  }
  if (!samples.empty())
  {
    std::sort(samples.begin(), samples.end(),
      [](const Sample& a, const Sample& b) { return a.Value < b.Value; });
    const double total = SumWeights(samples);
    statistics.Range = range                     ? *range
                       : kind == DataKind::IMAGE ? ComputeRangeOfImage(samples, total)
                                                 : ComputeRange(samples, total);
    statistics.Background = FindBackground(samples, total, statistics.Range);
  }
  return statistics;
}

TransferFunctions MakeDefaultTransferFunctions(const ValueStatistics& statistics)
{
  TransferFunctions functions;
  const auto& range = statistics.Range;
  const double background = statistics.Background;
  const double reach = std::max(range[1] - background, background - range[0]);
  const double position = (background - range[0]) / (range[1] - range[0]);
  if (position > 0.25 && position < 0.75)
  {
    AddDivergingColors(functions.Color, background, reach);
  }
  else
  {
    AddSequentialColors(functions.Color, range);
  }

  constexpr int steps = 16;
  constexpr double clear = 0.05;
  functions.Opacity->AddPoint(background, 0.0);
  for (int i = 0; i <= steps; ++i)
  {
    const double t = static_cast<double>(i) / steps;
    const double distance = reach * (clear + (1.0 - clear) * t);
    functions.Opacity->AddPoint(background - distance, t * t);
    functions.Opacity->AddPoint(background + distance, t * t);
  }
  return functions;
}

double ChooseUnitDistance(
  const std::vector<Sample>& samples, vtkPiecewiseFunction* opacity, double diagonal)
{
  const double side = diagonal / std::sqrt(3.0);
  if (!(side > 0.0))
  {
    return 1.0;
  }
  double weightedOpacity = 0.0;
  double volume = 0.0;
  for (const Sample& sample : samples)
  {
    weightedOpacity += sample.Volume * opacity->GetValue(sample.Value);
    volume += sample.Volume;
  }
  return side * std::clamp(volume > 0.0 ? weightedOpacity / volume : 1.0, 0.01, 1.0);
}

} // namespace tetmarch
