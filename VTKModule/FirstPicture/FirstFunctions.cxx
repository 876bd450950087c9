// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/FirstFunctions.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{

namespace
{

double reachOf(const ValueStatistics& statistics)
{
  return std::max(
    statistics.Range[1] - statistics.Background, statistics.Background - statistics.Range[0]);
}

// Samples of the map plasma, CC0.
void addSequentialColors(const std::array<double, 2>& range, vtkColorTransferFunction* colors)
{
  static const double plasma[][3] = { { 0.050, 0.030, 0.528 }, { 0.294, 0.012, 0.631 },
    { 0.492, 0.012, 0.658 }, { 0.658, 0.134, 0.588 }, { 0.798, 0.280, 0.470 },
    { 0.899, 0.424, 0.363 }, { 0.973, 0.580, 0.254 }, { 0.994, 0.772, 0.155 },
    { 0.940, 0.975, 0.131 } };
  constexpr int last = 8;
  colors->SetColorSpaceToLab();
  for (int i = 0; i <= last; ++i)
  {
    colors->AddRGBPoint(
      range[0] + (range[1] - range[0]) * i / last, plasma[i][0], plasma[i][1], plasma[i][2]);
  }
}

void addDivergingColors(double centre, double reach, vtkColorTransferFunction* colors)
{
  colors->SetColorSpaceToDiverging();
  colors->AddRGBPoint(centre - reach, 0.231, 0.298, 0.753);
  colors->AddRGBPoint(centre, 0.865, 0.865, 0.865);
  colors->AddRGBPoint(centre + reach, 0.706, 0.016, 0.150);
}

} // namespace

void makeFirstColors(const ValueStatistics& statistics, vtkColorTransferFunction* colors)
{
  const auto& range = statistics.Range;
  const double position = (statistics.Background - range[0]) / (range[1] - range[0]);
  colors->RemoveAllPoints();
  if (position > 0.25 && position < 0.75)
  {
    addDivergingColors(statistics.Background, reachOf(statistics), colors);
  }
  else
  {
    addSequentialColors(range, colors);
  }
}

void makeFirstOpacity(
  const ValueStatistics& statistics, const OpacityShape& shape, vtkPiecewiseFunction* opacity)
{
  constexpr int steps = 8;
  constexpr double clear = 0.05; // of the way to the end
  const double background = statistics.Background;
  const double reach = reachOf(statistics);
  const bool below = background - statistics.Range[0] > clear * reach;
  const bool above = statistics.Range[1] - background > clear * reach;
  opacity->RemoveAllPoints();
  opacity->AddPoint(background, shape.Least);
  for (int i = 0; i <= steps; ++i)
  {
    const double t = static_cast<double>(i) / steps;
    const double distance = reach * (clear + (1.0 - clear) * t);
    const double value = shape.Least + (shape.Most - shape.Least) * std::pow(t, shape.Exponent);
    if (below)
    {
      opacity->AddPoint(background - distance, value);
    }
    if (above)
    {
      opacity->AddPoint(background + distance, value);
    }
  }
}

} // namespace tetmarch
