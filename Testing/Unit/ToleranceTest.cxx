// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures keep the tolerance that is asked for, and the bound of the march is not far above the
// error.
#include "Shot.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// ParaView's default: a diverging colour map, and opacity as a ramp.
OpticalModel ramp()
{
  OpticalModel model =
    opticalModelOf({ { { 0.0, 0.231, 0.298, 0.753 } }, { { 0.5, 0.865, 0.865, 0.865 } },
                     { { 1.0, 0.706, 0.016, 0.149 } } },
      { { { 0.0, 0.0 } }, { { 1.0, 1.0 } } });
  model.Colour->SetColorSpaceToDiverging();
  return model;
}

OpticalModel smooth()
{
  std::vector<std::array<double, 4>> colours;
  std::vector<std::array<double, 2>> opacities;
  for (double f = 0.0; f < 1.001; f += 0.02)
  {
    colours.push_back(
      { { f, 0.5 + 0.5 * std::sin(5.0 * f), 0.5 + 0.5 * std::cos(7.0 * f), 1.0 - f } });
    opacities.push_back({ { f, 0.3 + 0.3 * std::sin(9.0 * f) } });
  }
  return opticalModelOf(colours, opacities);
}

OpticalModel spikes()
{
  std::vector<std::array<double, 2>> opacities;
  for (const double f : { 0.203, 0.411, 0.617, 0.83 })
  {
    opacities.push_back({ { f - 0.004, 0.0 } });
    opacities.push_back({ { f, 1.0 } });
    opacities.push_back({ { f + 0.004, 0.0 } });
  }
  return opticalModelOf(
    { { { 0.0, 0.1, 0.2, 0.9 } }, { { 0.45, 0.9, 0.9, 0.3 } }, { { 1.0, 0.9, 0.1, 0.1 } } },
    opacities);
}

struct Tally
{
  std::size_t Pixels = 0;
  std::size_t Over = 0; // the tolerance
  double Worst = 0.0;
  std::size_t BeyondBound = 0;
  std::vector<double> Pessimism; // bound over error, of pixels that are off at all
};

void add(Tally& tally, const ReferenceImage& image, const ReferenceImage& exact, double tolerance)
{
  for (std::size_t i = 0; i < image.ErrorBounds.size(); ++i)
  {
    double error = 0.0;
    for (std::size_t k = 4 * i; k < 4 * i + 4; ++k)
    {
      error = std::max(error, std::abs(double(image.Pixels[k]) - double(exact.Pixels[k])));
    }
    if (exact.Pixels[4 * i + 3] > 0.0f)
    {
      ++tally.Pixels;
      tally.Over += error > tolerance;
      tally.Worst = std::max(tally.Worst, error);
      if (error > 1e-5) // what float and the ground truth leave open
      {
        tally.Pessimism.push_back(double(image.ErrorBounds[i]) / error);
      }
    }
  }
}

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

class Tolerance : public ::testing::TestWithParam<double>
{
};

TEST_P(Tolerance, IsKeptAndTheBoundIsNear)
{
  AccuracyLevel level = levelOf(Accuracy::Default, GetParam());
  Tally tally;
  std::vector<double> pessimism;
  const Grid grids[] = { jitteredLattice(6, 0.15, 1, noiseField()),
    jitteredLattice(14, 0.15, 1, sineField()) };
  for (const auto& [name, optics] : { std::pair<const char*, OpticalModel>{ "smooth", smooth() },
         { "ramp", ramp() }, { "spikes", spikes() } })
  {
    for (const Grid& grid : grids)
    {
      for (const double unitDistance : { 0.3, 0.03 })
      {
        Shot shot;
        shot.Data = grid;
        shot.Optics = optics;
        shot.UnitDistance = unitDistance;
        Tally own;
        const ReferenceImage exact = byMarch<double>(shot, GroundTruthAccuracy);
        add(own, byMarch<float>(shot, level), exact, level.ErrorTolerance);
        std::cout << "[ MEASURED ] " << name << ' ' << grid->GetNumberOfCells() << " cells, unit "
                  << unitDistance << ": worst " << own.Worst / level.ErrorTolerance
                  << " tolerances, " << own.Over << " of " << own.Pixels << " pixels over; bound "
                  << (own.Pessimism.empty() ? 0.0 : median(own.Pessimism)) << " times the error\n";
        tally.Pixels += own.Pixels;
        tally.Over += own.Over;
        pessimism.insert(pessimism.end(), own.Pessimism.begin(), own.Pessimism.end());
      }
    }
  }
  EXPECT_GT(tally.Pixels, 10000u);
  EXPECT_LE(double(tally.Over), 1e-4 * double(tally.Pixels));
  ASSERT_GT(pessimism.size(), 1000u);
  EXPECT_LE(median(pessimism), 20.0);
}

INSTANTIATE_TEST_SUITE_P(Of, Tolerance, ::testing::Values(1.0 / 32.0, 1.0 / 255.0, 1.0 / 1024.0),
  [](const auto& of) { return "One" + std::to_string(std::lround(1.0 / of.param)) + "th"; });
} // namespace
