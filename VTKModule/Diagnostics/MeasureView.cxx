// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Diagnostics/MeasureView.h"

#include "vtkLookupTable.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace tetmarch
{
namespace
{

// Decades, and parts of a bar of counts, between its labels.
constexpr int Parts = 4;
// Below the rounding of float.
constexpr double LeastError = 1e-9;

double greatest(Measure what, const std::vector<float>& measures)
{
  float most = 0.0f;
  for (std::size_t i = 0; i < measures.size(); i += 4)
  {
    const float value = measures[i + static_cast<std::size_t>(what)];
    const bool hasBound = !(measures[i + 3] > 0);
    most = std::isfinite(value) && hasBound ? std::max(most, value) : most;
  }
  return double(most);
}

// Rounded up to a whole number of one or two significant digits.
double roundedUp(double value)
{
  double unit = 1.0;
  for (;; unit *= 10.0)
  {
    for (const double digits : { 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0 })
    {
      const double step = digits * unit;
      if (step >= value && step == std::floor(step))
      {
        return step;
      }
    }
  }
}

} // namespace

std::string describeBadRange(const MeasureView& view)
{
  const auto [low, high] = view.Range;
  if (view.Automatic)
  {
    return {};
  }
  std::string wrong;
  if (!std::isfinite(low) || !std::isfinite(high))
  {
    wrong = "both ends must be finite";
  }
  else if (!(low < high))
  {
    wrong = "the first number must be below the second";
  }
  else if (view.isLogarithmic() && !(low > 0))
  {
    wrong = "error bounds are shown on a logarithmic scale, which begins above 0";
  }
  if (wrong.empty())
  {
    return {};
  }
  std::ostringstream text;
  text << "The range of the view, " << low << " to " << high << ", can't be shown: " << wrong
       << ". SetViewRange() sets another, AutomaticViewRangeOn() takes it from each frame.";
  return text.str();
}

std::array<double, 2> automaticRange(Measure what, const std::vector<float>& measures)
{
  const double most = greatest(what, measures);
  if (what != Measure::ErrorBound)
  {
    return { { 0.0, Parts * roundedUp(most / Parts) } };
  }
  // A float that is a power of ten up to rounding maps to that power.
  const double exponent = std::ceil(std::log10(std::max(most, LeastError)) - 1e-6);
  return { { std::pow(10.0, exponent - Parts), std::pow(10.0, exponent) } };
}

void fitTable(const MeasureView& view, const std::vector<float>& measures)
{
  const std::array<double, 2> range =
    view.Automatic ? automaticRange(view.What, measures) : view.Range;
  view.Table->SetScaleToLinear(); // the new range may be invalid for logarithms
  view.Table->SetTableRange(range[0], range[1]);
  if (view.isLogarithmic())
  {
    view.Table->SetScaleToLog10();
  }
}

} // namespace tetmarch
