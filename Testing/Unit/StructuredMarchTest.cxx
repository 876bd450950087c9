// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march through structured volumes against the ground truth.
#include "Reference/ConstantKernel.h"
#include "Reference/FastTrilinearKernel.h"
#include "Reference/TrilinearKernel.h"

#include "StructuredRays.h"

#include <cmath>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

template <typename Kernel>
RayTally tallyOf(const StructuredRays& rays, int count)
{
  RayTally tally;
  tallyTruth<Kernel>(tally, rays, count);
  EXPECT_EQ(tally.Lost, 0);
  return tally;
}

template <typename Real>
RayTally tallyOf(const StructuredRays& rays)
{
  return rays.Cells.Constant ? tallyOf<ConstantKernel<Real>>(rays, 200)
                             : tallyOf<TrilinearKernel<Real>>(rays, 200);
}

TEST(StructuredMarch, IsTheGroundTruthWhereverImagesAre)
{
  for (const ImagePlace& place : imagePlaces())
  {
    const auto image = imageOf(scatteredField(1), place);
    for (const LatticeValues values : AllLatticeValues)
    {
      SCOPED_TRACE(std::string(place.Name) + ", values " + std::to_string(int(values)));
      const StructuredRays rays(image, values, rampAndPeak(0.1 * image->GetLength()));
      EXPECT_LT(tallyOf<double>(rays).Worst, 2e-6);
      EXPECT_LT(tallyOf<float>(rays).Worst, 1e-5);
    }
  }
}

// With the tables of the level, so that the errors between their entries are included.
template <typename Kernel>
void expectBound(const AccuracyLevel& level, int count)
{
  for (const double unit : { 0.02, 0.1, 0.5 })
  {
    const StructuredRays rays(imageOf(scatteredField(2), unitCube(6)), LatticeValues::PointsLinear,
      rampAndPeak(unit), level);
    const RayTally found = tallyOf<Kernel>(rays, count);
    EXPECT_LT(found.Worst, level.Adaptive ? level.ErrorTolerance : 1) << unit;
    EXPECT_EQ(found.BeyondBound, 0) << unit;
    report(level.Adaptive ? "adaptive" : "even cuts", found);
  }
}

TEST(StructuredMarch, KeepsItsTolerance)
{
  for (const double tolerance : { 1.0 / 255, 1.0 / 1024 })
  {
    expectBound<TrilinearKernel<double>>(levelOf(Accuracy::Default, tolerance), 1000);
  }
}

// Nothing but the bound is promised.
TEST(StructuredMarch, EvenCutsKeepTheirBound)
{
  expectBound<FastTrilinearKernel<double>>(levelOf(Accuracy::Fast, 1.0), 2000);
}

// A field that is linear needs no cuts; where cells are thin, only the table's bins are lost.
TEST(StructuredMarch, EvenCutsLoseLittleInALinearField)
{
  const Field linear = [](double x, double y, double z) { return 0.5 * x + 0.3 * y + 0.2 * z; };
  const StructuredRays rays(imageOf(linear, unitCube(6)), LatticeValues::PointsLinear,
    rampAndPeak(40), levelOf(Accuracy::Fast, 1.0));
  // Half of what the extinction rises in a bin of the peak, along the longest ray.
  const double risePerBin = -std::log(1 - 0.9) / 20;
  EXPECT_LT((tallyOf<FastTrilinearKernel<double>>(rays, 1000).Worst),
    0.5 * risePerBin * std::sqrt(3.0) / 40);
}
} // namespace
