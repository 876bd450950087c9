// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Where rays are picked in trilinear cells, against the ground truth by brute force.
#include "Reference/PickTrilinearKernel.h"

#include "StructuredRays.h"

#include "Fields.h"

#include <algorithm>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

struct Tally
{
  int Hits = 0;
  int Misses = 0;
  double WorstOpacity = 0;
  double WorstScalar = 0; // as it is stored
};

// As it is stored.
double scalarAt(const StructuredRays& rays, const LatticePart& part, double depth)
{
  const ScalarRange& range = rays.Values[0].Range;
  LatticePart whole = part;
  whole.Begin -= 4;
  for (const ScalarSegment& segment : rays.segments(whole, whole.End))
  {
    if (segment.T0 <= depth && depth <= segment.T1)
    {
      const double value = segment.Scalar.at((depth - segment.T0) / (segment.T1 - segment.T0));
      return (value - range.Low) / range.width();
    }
  }
  return std::nan("");
}

// The opacity up to the point is what is asked for.
template <typename Real>
void pickRays(const StructuredRays& rays, int count, unsigned seed, Tally& tally)
{
  constexpr double Tolerance = PickAccuracy.ErrorTolerance;
  auto kernel = rays.kernel<PickTrilinearKernel<Real>>();
  kernel.mostTrials = PickAccuracy.MostTrials;
  std::mt19937 random(seed);
  for (int i = 0; i < count; ++i)
  {
    const LatticePart part = rays.nextPart(random, i, 0.9);
    const double threshold = 0.02 + 0.96 * uniform(random);
    const auto ray = part.of(kernel);
    const Real left = Real(1.0 - threshold);
    kernel.errorTolerance = left; // as the mapper has it
    const auto pick =
      kernel.pickOn(ray, Real(part.perDepth()), Real(part.Begin), Real(part.End), left);
    const double all = rays.truth(part, part.End)[3];
    if (std::abs(all - threshold) > Tolerance)
    {
      ASSERT_EQ(pick.hit, all > threshold) << all << " of " << threshold;
    }
    tally.Hits += pick.hit ? 1 : 0;
    tally.Misses += pick.hit ? 0 : 1;
    if (pick.hit)
    {
      const double depth = double(pick.depth);
      tally.WorstOpacity =
        std::max(tally.WorstOpacity, std::abs(rays.truth(part, depth)[3] - threshold));
      const double expected = scalarAt(rays, part, depth);
      tally.WorstScalar = std::max(tally.WorstScalar, std::abs(double(pick.scalar) - expected));
    }
  }
}

void expectPicks(vtkDataSet* data, LatticeValues values)
{
  for (const double unit : { 0.02, 0.1, 0.5 }) // from a part of a cell to several
  {
    SCOPED_TRACE(unit);
    const StructuredRays rays(data, values, rampAndPeak(unit));
    Tally tally;
    ASSERT_NO_FATAL_FAILURE(pickRays<double>(rays, 400, 11, tally));
    ASSERT_NO_FATAL_FAILURE(pickRays<float>(rays, 400, 12, tally));
    EXPECT_GT(tally.Hits, 100);
    EXPECT_LE(tally.WorstOpacity, PickAccuracy.ErrorTolerance);
    EXPECT_LE(tally.WorstScalar, 1e-4);
    std::cout << "[ MEASURED ] unit " << unit << ": " << tally.Hits << " hits, " << tally.Misses
              << " misses, opacities within " << tally.WorstOpacity << ", scalars within "
              << tally.WorstScalar << '\n';
  }
}

TEST(StructuredPick, IsAtTheOpacityThatIsAskedFor)
{
  expectPicks(imageOf(scatteredField(1), unitCube(6)), LatticeValues::PointsLinear);
  expectPicks(imageOf(scatteredField(2), unitCube(6)), LatticeValues::CellsLinear);
  expectPicks(rectilinearOf(scatteredField(3), unevenCube(6)), LatticeValues::PointsLinear);
}
} // namespace
