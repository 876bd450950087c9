// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DefaultTransferFunction.h"

#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
using tetmarch::Sample;

constexpr vtkIdType MaximumSamples = 1 << 20;

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

double FindBackground(
  const std::vector<Sample>& samples, double total, const std::array<double, 2>& range)
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
    near += std::abs(sample.Value - mode) <= 0.02 * (range[1] - range[0]) ? GetWeight(sample) : 0.0;
  }
  return near >= 0.1 * total ? mode : range[0];
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

double ValueOf(const tetmarch::ArraySelection& selection, vtkIdType tuple)
{
  if (selection.Component >= 0)
  {
    return selection.Array->GetComponent(tuple, selection.Component);
  }
  double square = 0.0;
  for (int i = 0; i < selection.Array->GetNumberOfComponents(); ++i)
  {
    const double component = selection.Array->GetComponent(tuple, i);
    square += component * component;
  }
  return std::sqrt(square);
}
} // namespace

namespace tetmarch
{

std::vector<Sample> TakeSamples(vtkUnstructuredGrid* grid, const ArraySelection& selection)
{
  const vtkIdType count = grid->GetNumberOfCells();
  const vtkIdType step = std::max<vtkIdType>(1, count / MaximumSamples);
  vtkNew<vtkIdList> points;
  std::vector<Sample> samples;
  samples.reserve(static_cast<std::size_t>(count / step + 1));
  for (vtkIdType cell = 0; cell < count; cell += step)
  {
    double value = 0.0;
    if (selection.Where == Association::CELLS)
    {
      value = ValueOf(selection, cell);
    }
    else
    {
      grid->GetCellPoints(cell, points);
      for (const vtkIdType point : *points)
      {
        value += ValueOf(selection, point);
      }
      value /= static_cast<double>(points->GetNumberOfIds());
    }
    double bounds[6];
    grid->GetCellBounds(cell, bounds);
    const double volume =
      (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]) * (bounds[5] - bounds[4]);
    if (std::isfinite(value) && volume > 0.0)
    {
      samples.push_back({ value, volume });
    }
  }
  return samples;
}

ValueStatistics ComputeStatistics(
  std::vector<Sample> samples, const std::optional<std::array<double, 2>>& range)
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
    statistics.Range = range ? *range : ComputeRange(samples, total);
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
