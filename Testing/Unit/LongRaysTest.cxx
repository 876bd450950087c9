// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What adds up along rays of many thousand segments is within the bound of the error: the rounding
// of sums, and the steps of the integrals of transfer functions.
#include "Reference/MakeKernel.h"
#include "Reference/PointKernel.h"
#include "Reference/SumPointKernel.h"

#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <random>

namespace
{
using namespace tetmarch;

struct Step
{
  float Begin; // depths
  float End;
  float From; // scalars
  float To;
};

// 100,000 steps or more from depth -1 to 1; even ones are rounded to the same side each time.
std::vector<Step> stepsOf(bool even)
{
  std::mt19937 random(5);
  const auto share = [&] { return std::ldexp(static_cast<float>(random() >> 8), -24); };
  std::vector<Step> steps;
  float scalar = 0.3f;
  for (float begin = -1; begin < 1;)
  {
    const float end = begin + (even ? std::ldexp(1.0f, -16) : 4e-5f * share() + 1e-7f);
    const float to = even ? 0.3f + 0.4f * static_cast<float>(steps.size() % 2) : share();
    steps.push_back({ begin, end, scalar, to });
    scalar = to;
    begin = end;
  }
  return steps;
}

struct Sum
{
  double Gray = 0;
  double OneByOne = 0; // the same, its terms added as they are
  double Bound = 0;
};

template <typename Real>
Sum sumOf(const std::vector<Step>& steps, const IntegralTable& table, const Blending& blending)
{
  using Kernel = SumPointKernel<Real>;
  auto kernel = makeKernel<Kernel, Real>(table, ScalarRange(), DefaultAccuracy);
  kernel.useBlending(blending);
  const auto none = kernel.noRadiance();
  auto radiance = none;
  Real sum = 0, length = 0;
  typename Kernel::CellInterval cell{};
  const Real thickness = Real(1.5f);
  for (const Step& step : steps)
  {
    typename Kernel::Segment segment{};
    segment.begin = { Real(step.Begin), Real(step.From) };
    segment.end = { Real(step.End), Real(step.To) };
    kernel.gatherSegment(segment, thickness, cell, radiance);
    auto single = none;
    kernel.gatherSegment(segment, thickness, cell, single);
    sum = sum + kernel.valueOf(single.sum);
    length = length + kernel.valueOf(single.countedLength);
  }
  const Real factor = kernel.averages ? Real(1) / length : thickness;
  return { double(kernel.pixelOf(radiance, thickness).x), double(sum * factor),
    double(kernel.errorBound(radiance)) };
}

TEST(LongRays, SumsAndAveragesKeepTheirBound)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.1);
  opacity->AddPoint(1.0, 0.9);
  vtkNew<vtkVolumeProperty> property;
  property->SetScalarOpacity(opacity);
  double worst = 0;
  for (const bool averages : { false, true })
  {
    Blending blending;
    blending.Mode = averages ? BlendMode::Average : BlendMode::Additive;
    blending.AverageRange =
      averages ? std::array<float, 2>{ { 0.25f, 0.6f } } : std::array<float, 2>{ { -1, 2 } };
    const IntegralTable table =
      blendedTable(property, OpacityLaw::Unstructured, blending, ScalarRange(), DefaultAccuracy);
    for (const bool even : { false, true })
    {
      const std::vector<Step> steps = stepsOf(even);
      ASSERT_GT(steps.size(), 90000u);
      const Sum exact = sumOf<double>(steps, table, blending);
      const Sum found = sumOf<float>(steps, table, blending);
      ASSERT_GT(exact.Gray, 0.1);
      ASSERT_LT(exact.Gray, 0.97);
      EXPECT_LE(std::abs(found.Gray - exact.Gray), found.Bound) << averages << even;
      EXPECT_LT(found.Bound, 2e-6);
      const double naive = std::abs(found.OneByOne - exact.Gray);
      worst = std::max(worst, naive);
      std::cout << "[ MEASURED ] " << steps.size() << " terms: off by "
                << std::abs(found.Gray - exact.Gray) << ", added as they are by " << naive
                << ", bound " << found.Bound << '\n';
    }
  }
  EXPECT_GT(worst, 2e-5); // the case is one that compensation is for
}

// A table with many entries of which half are opaque: its integrals have great steps.
IntegralTable tableWithGreatSteps()
{
  SampledFunctions functions;
  const int samples = samplesOfTable(65536);
  for (int i = 0; i < samples; ++i)
  {
    const double s = i / (samples - 1.0);
    const double extinction =
      s < 0.5 ? 6e-5 * (1 + std::sin(20 * s)) : extinctionOf(1.0, OpacityLaw::Structured);
    functions.Samples.push_back({ { 1, 1, 1, extinction } });
  }
  functions.Before = functions.Samples.front();
  functions.After = functions.Samples.back();
  return makeIntegralTable(functions);
}

// The extinction of a table between two of its entries, by the trapezoids of its values.
class Extinction
{
public:
  explicit Extinction(const IntegralTable& table)
    : Table(table)
  {
    this->UpTo.push_back(0);
    for (int i = 1; i < table.size(); ++i)
    {
      this->UpTo.push_back(
        this->UpTo.back() + 0.5 * (double(table.Values[i - 1][3]) + double(table.Values[i][3])));
    }
  }
  double mean(double p, double q) const { return (this->upTo(q) - this->upTo(p)) / (q - p); }

private:
  double upTo(double x) const
  {
    const auto bin = static_cast<std::size_t>(x);
    const double begin = double(this->Table.Values[bin][3]);
    const double slope = double(this->Table.Values[bin + 1][3]) - begin;
    const double share = x - double(bin);
    return this->UpTo[bin] + share * (begin + 0.5 * slope * share);
  }

  const IntegralTable& Table;
  std::vector<double> UpTo;
};

TEST(LongRays, StepsOfTheIntegralsAreInTheBound)
{
  using Kernel = PointKernel<double>;
  const IntegralTable table = tableWithGreatSteps();
  const Extinction extinction(table);
  AccuracyLevel level = GroundTruthAccuracy;
  level.MostTrials = 0;
  auto kernel = makeKernel<Kernel, double>(table, ScalarRange(), level);
  std::mt19937 random(8);
  const auto share = [&] { return std::ldexp(static_cast<double>(random() >> 8), -24); };
  double worst = 0;
  for (int ray = 0; ray < 60; ++ray)
  {
    // To and fro over a few entries.
    const double first = 0.1 + 0.3 * share();
    const double last = first + (2 + 4 * share()) / table.size();
    const double thickness = 0.2;
    auto radiance = kernel.noRadiance();
    Kernel::CellInterval cell{};
    double depth = 0; // optical
    for (int i = 0; i < 2000; ++i)
    {
      Kernel::Segment segment{};
      segment.begin = { i * thickness, i % 2 == 0 ? first : last };
      segment.end = { (i + 1) * thickness, i % 2 == 0 ? last : first };
      kernel.gatherSegment(segment, 1.0, cell, radiance);
      depth += thickness * extinction.mean(first * kernel.tableScale + kernel.tableOffset,
                             last * kernel.tableScale + kernel.tableOffset);
    }
    const double exact = 1 - std::exp(-depth);
    const double opacity = 1 - radiance.transmittance;
    const double error =
      std::max(std::abs(opacity - exact), std::abs(double(radiance.color.x) - exact));
    EXPECT_LE(error, kernel.errorBound(radiance) + 1e-12) << ray;
    EXPECT_LT(radiance.error, 1e-12); // what is bounded by the colours' order
    worst = std::max(worst, error);
  }
  std::cout << "[ MEASURED ] off by up to " << worst << " of 2000 segments, a step is "
            << table.IntegralUnit[3] << '\n';
  EXPECT_GT(worst, 1e-3);
}
} // namespace
