// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Optics/GradientOpacityTable.h"

#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetmarch
{
namespace
{

constexpr int Steps = GradientOpacityTable::Steps;

double factorOf(double value)
{
  return std::min(std::max(0.0, value), 1.0); // NaN: 0
}

// The magnitude up to which the function is sampled; 0 if only its value at 0 is needed.
double sampledRange(vtkPiecewiseFunction* function, double mostMagnitude)
{
  const double last = function->GetSize() > 0 ? function->GetRange()[1] : 0;
  // Unless it is clamped, the function drops to 0 beyond its last node; this takes one more step.
  const double end = function->GetClamping() ? last : last * (Steps / (Steps - 1.0));
  const double range = std::isfinite(mostMagnitude) ? std::min(mostMagnitude, end) : end;
  const bool usable = std::isfinite(range) && range / Steps > 0;
  return usable ? range : 0;
}

// Extremes of the function are nodes, which may lie between samples. The first and the last sample
// are not changed: a large part of the data may have magnitude 0, or that of the last sample or
// more.
void keepNodes(vtkPiecewiseFunction* function, double unit, std::vector<double>& values)
{
  const std::vector<double> samples = values;
  const auto excess = [&](std::size_t i, double value)
  {
    const auto [low, high] = std::minmax(samples[i], samples[i + 1]);
    return std::max(low - value, value - high);
  };
  std::vector<double> most(samples.size(), 0.0);
  std::array<double, 4> node{};
  for (int n = 0; n < function->GetSize(); ++n)
  {
    function->GetNodeValue(n, node.data());
    const double x = node[0] / unit;
    if (!(x > 0 && x < Steps))
    {
      continue;
    }
    const double value = factorOf(node[1]);
    const double beyond = excess(static_cast<std::size_t>(x), value);
    const long nearest = std::min(std::max(std::lround(x), 1L), Steps - 1L);
    // Differences by VTK's rounding are no peaks.
    if (beyond > std::max(most[nearest], 1e-9))
    {
      most[nearest] = beyond;
      values[nearest] = value;
    }
  }
}

} // namespace

GradientOpacityTable gradientOpacityOf(vtkVolumeProperty* property, double mostMagnitude)
{
  GradientOpacityTable table;
  // A 2D function of scalar and gradient replaces this function.
  if (property->GetDisableGradientOpacity() || !property->HasGradientOpacity() ||
      property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D)
  {
    return table;
  }
  vtkPiecewiseFunction* function = property->GetGradientOpacity();
  const double range = sampledRange(function, mostMagnitude);
  std::vector<double> values(Steps + 1);
  function->GetTable(0.0, range, Steps + 1, values.data());
  std::transform(values.begin(), values.end(), values.begin(), factorOf);
  if (range > 0)
  {
    table.Unit = range / Steps;
    keepNodes(function, table.Unit, values);
  }
  table.Values.assign(values.begin(), values.end());
  // In float, a value that VTK rounds next to 1 is 1.
  if (std::all_of(table.Values.begin(), table.Values.end(), [](float v) { return v == 1.0f; }))
  {
    table.Values.clear();
  }
  return table;
}

} // namespace tetmarch
