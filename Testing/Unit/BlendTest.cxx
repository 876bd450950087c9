// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Extremes, sums and averages against closed forms: a linear field in the unit cube, rays of all
// kinds.
#include "Reference/ExtremePointKernel.h"
#include "Reference/SumPointKernel.h"

#include "BlendedColors.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// The mean of opacity(s) s for s from p to q.
double meanIntensity(double p, double q)
{
  const auto integral = [](double s) { return 0.1 * s * s + 0.2 * s * s * s; };
  return std::abs(q - p) < 1e-9 ? BlendedRays::opacity(p) * p
                                : (integral(q) - integral(p)) / (q - p);
}

TEST(Blend, MaximumAndMinimum)
{
  BlendedRays rays(jitteredLattice(5, 0.15, 1, linearField()));
  for (const bool greatest : { true, false })
  {
    rays.use(greatest ? BlendMode::Maximum : BlendMode::Minimum);
    const auto expected = [greatest](const ScalarChord& c, Rgba& known)
    {
      known = BlendedRays::premultiplied(
        greatest ? std::max(c.First, c.Last) : std::min(c.First, c.Last));
      return true;
    };
    expectRays<ExtremePointKernel<double>, double>(rays, linearField(), expected);
    expectRays<ExtremePointKernel<float>, float>(rays, linearField(), expected);
  }
}

TEST(Blend, AdditiveIsTheIntegralUpToOne)
{
  BlendedRays rays(jitteredLattice(5, 0.15, 1, linearField()));
  rays.use(BlendMode::Additive, { { 0.5, 0.6 } }); // the range is used by averages alone
  int clamped = 0;
  const auto expected = [&](const ScalarChord& c, Rgba& known)
  {
    const double sum = meanIntensity(c.First, c.Last) * c.Optical;
    clamped += sum > 1 ? 1 : 0;
    known = gray(std::min(sum, 1.0));
    return true;
  };
  expectRays<SumPointKernel<double>, double>(rays, linearField(), expected);
  expectRays<SumPointKernel<float>, float>(rays, linearField(), expected);
  EXPECT_GT(clamped, 10);
}

TEST(Blend, AverageOverTheRange)
{
  BlendedRays rays(jitteredLattice(5, 0.15, 1, linearField()));
  for (const std::array<double, 2>& range : { std::array<double, 2>{ { -1e38, 1e38 } },
         std::array<double, 2>{ { 0.4, 0.55 } }, std::array<double, 2>{ { 0.5, 7.0 } } })
  {
    rays.use(BlendMode::Average, range);
    const auto expected = [&](const ScalarChord& c, Rgba& known)
    {
      const double low = std::max(std::min(c.First, c.Last), range[0]);
      const double high = std::min(std::max(c.First, c.Last), range[1]);
      if (high > low)
      {
        known = gray(meanIntensity(low, high));
      }
      return std::abs(high - low) > 1e-3; // else rounding decides whether there is anything
    };
    expectRays<SumPointKernel<double>, double>(rays, linearField(), expected);
    expectRays<SumPointKernel<float>, float>(rays, linearField(), expected);
  }
}

TEST(Blend, AverageOfNothingIsNothing)
{
  BlendedRays rays(jitteredLattice(3, 0.15, 1, linearField()));
  for (const std::array<double, 2>& range : { std::array<double, 2>{ { 0.7, 0.3 } },
         std::array<double, 2>{ { 2.0, 3.0 } }, std::array<double, 2>{ { std::nan(""), 1.0 } } })
  {
    rays.use(BlendMode::Average, range);
    expectRays<SumPointKernel<float>, float>(rays, linearField(),
      [](const ScalarChord&, Rgba& known)
      {
        known = {};
        return true;
      });
  }
}

TEST(Blend, ScalarsThatAreNotFiniteDoNotCount)
{
  Grid grid = jitteredLattice(4, 0.0, 1, AlongX);
  vtkDataArray* values = grid->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double x = values->GetComponent(i, 0);
    values->SetComponent(i, 0, x > 0.6 && x < 0.9 ? std::nan("") : x);
  }
  BlendedRays rays(grid);
  rays.use(BlendMode::Maximum);
  expectRays<ExtremePointKernel<double>, double>(rays, AlongX,
    [](const ScalarChord& c, Rgba& known)
    {
      const double low = std::min(c.First, c.Last);
      known =
        low < 0.5 ? BlendedRays::premultiplied(std::min(std::max(c.First, c.Last), 0.5)) : Rgba{};
      return std::abs(low - 0.5) > 1e-4;
    });
}
} // namespace
