// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The shaders' loops end whatever the numbers are, also where a compiler has turned comparisons
// round (TurnedNumber.h). What never ends would hang the device.
#include "Reference/FastTrilinearKernel.h"
#include "Reference/MakeKernel.h"
#include "Reference/PointKernel.h"
#include "Reference/TrilinearKernel.h"

#include "TurnedNumber.h"

#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;
using Number = tetmarch::testing::TurnedNumber;

constexpr float Infinite = std::numeric_limits<float>::infinity();
constexpr float Numbers[] = { 0.0f, 0.3f, 1e30f, Infinite, -Infinite,
  std::numeric_limits<float>::quiet_NaN() };

// All combinations of such numbers.
template <typename Call>
void forAll(const Call& call)
{
  for (const float a : Numbers)
  {
    for (const float b : Numbers)
    {
      for (const float c : Numbers)
      {
        for (const float d : Numbers)
        {
          call(Number(a), Number(b), Number(c), Number(d));
        }
      }
    }
  }
}

IntegralTable table()
{
  SampledFunctions functions;
  for (int i = 0; i < samplesOfTable(1024); ++i)
  {
    const double s = i / 1019.0;
    functions.Samples.push_back({ { s, 1 - s, 0.5, i % 50 == 0 ? 100.0 : 0.1 } });
  }
  functions.Before = functions.Samples.front();
  functions.After = functions.Samples.back();
  IntegralTable made = makeIntegralTable(functions);
  addExtinctionVariations(made);
  addSlopeVariations(made);
  return made;
}

template <typename Kernel, typename Bend>
void expectSegmentsToEnd(const Bend& bend)
{
  const IntegralTable made = table();
  auto kernel = makeKernel<Kernel, Number>(made, ScalarRange(), DefaultAccuracy);
  kernel.mostSteps = 1000;
  int most = 0;
  forAll(
    [&](Number thickness, Number from, Number to, Number tolerance)
    {
      kernel.errorTolerance = tolerance;
      typename Kernel::CellInterval cell{};
      typename Kernel::Segment segment{};
      segment.begin = { Number(0), from };
      segment.end = { Number(1), to };
      bend(segment, thickness);
      auto radiance = kernel.noRadiance();
      most = std::max(most, kernel.integrateSegment(segment, thickness, cell, radiance));
    });
  // mostTurns of segment_linear.glsl, and the turn that finds them done.
  EXPECT_LE(most, 16 * DefaultAccuracy.MostTrials + 2 + 1);
  EXPECT_GT(most, 4);
}

TEST(EndlessLoops, AreNotInTetrahedra)
{
  expectSegmentsToEnd<PointKernel<Number>>([](auto&, Number) {});
}

TEST(EndlessLoops, AreNotWhereTheScalarBends)
{
  const auto bend = [](auto& segment, Number by) { segment.bend = { by, by }; };
  expectSegmentsToEnd<TrilinearKernel<Number>>(bend);
  expectSegmentsToEnd<FastTrilinearKernel<Number>>(bend);
}

TEST(EndlessLoops, AreNotBetweenPlanesOfTheCropping)
{
  PointKernel<Number> kernel;
  kernel.mostSteps = 100;
  kernel.croppingFlags = 0; // nothing is left
  forAll(
    [&](Number a, Number b, Number begin, Number end)
    {
      PointKernel<Number>::Ray ray{};
      ray.origin = { a, b, Number(0) };
      ray.direction = { b, Number(0), Number(1) };
      ray.lowDepth = { a, b, a };
      ray.highDepth = { b, a, b };
      kernel.nextRange(ray, begin, end);
    });
}

// A cell without a scalar has no extremes, and so one part: its coefficients are as great as the
// value that stands for none, and their products are not finite.
TEST(EndlessLoops, AreNotInCellsWithoutAScalar)
{
  TrilinearKernel<Number> kernel;
  for (const float a : Numbers)
  {
    for (const float b : Numbers)
    {
      const auto none =
        kernel.extremesOf({ Number(UndrawnScalar), Number(a), Number(b), Number(-1e30f) });
      EXPECT_EQ(float(none.x), 2.0f) << a << ' ' << b;
      EXPECT_EQ(float(none.y), 2.0f) << a << ' ' << b;
    }
  }
  const auto two = kernel.extremesOf({ Number(0.5f), Number(0.1f), Number(-0.45f), Number(0.3f) });
  EXPECT_TRUE(float(two.x) > 0 && float(two.x) < 1);
}
} // namespace
