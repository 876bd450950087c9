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

// Another number for each point: no scalar bends more.
Field noise(unsigned seed)
{
  return [seed](double x, double y, double z)
  {
    const double s = std::sin(12.9898 * x + 78.233 * y + 37.719 * z + seed) * 43758.5453;
    return s - std::floor(s);
  };
}

struct Tally
{
  int Hits = 0;
  int Misses = 0;
  double WorstOpacity = 0;
  double WorstScalar = 0; // as it is stored
};

// As it is stored, at a length from the point.
double scalarAt(const StructuredRays& rays, const tetmarch::testing::Vec3& point,
  const tetmarch::testing::Vec3& direction, double length)
{
  const Vector3 origin = rays.Cells.Frame.toData({ { point[0], point[1], point[2] } });
  const double t = length * rays.Cells.Frame.Radius;
  const ScalarRange& range = rays.Values[0].Range;
  for (const ScalarSegment& segment :
    rays.Truth.segments({ origin[0], origin[1], origin[2] }, direction, -LatticeTruth::Infinity))
  {
    if (segment.T0 <= t && t <= segment.T1)
    {
      const auto value =
        static_cast<double>(segment.Scalar.at((t - segment.T0) / (segment.T1 - segment.T0)));
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
  using Kernel = PickTrilinearKernel<Real>;
  auto kernel = rays.kernel<Kernel, Real>();
  kernel.mostTrials = PickAccuracy.MostTrials;
  std::mt19937 random(seed);
  for (int i = 0; i < count; ++i)
  {
    const tetmarch::testing::Vec3 point = rays.pointNear(random, 0.9);
    const tetmarch::testing::Vec3 d = StructuredRays::direction(random);
    const double begin = i % 3 ? -4.0 : 0.1 * StructuredRays::share(random);
    const double threshold = 0.02 + 0.96 * StructuredRays::share(random);
    const auto ray = kernel.rayThrough(
      { Real(point[0]), Real(point[1]), Real(point[2]) }, { Real(d[0]), Real(d[1]), Real(d[2]) });
    const double offset = point[0] * d[0] + point[1] * d[1] + point[2] * d[2];
    const Real left = Real(1.0 - threshold);
    kernel.errorTolerance = left; // as the mapper has it
    const auto pick =
      kernel.pickOn(ray, Real(rays.PerDepth), Real(begin + offset), Real(4.0 + offset), left);
    const double all = rays.truth(point, d, begin, 4.0)[3];
    if (std::abs(all - threshold) > Tolerance)
    {
      ASSERT_EQ(pick.hit, all > threshold) << all << " of " << threshold;
    }
    tally.Hits += pick.hit ? 1 : 0;
    tally.Misses += pick.hit ? 0 : 1;
    if (pick.hit)
    {
      const double length = double(pick.depth) - offset;
      tally.WorstOpacity =
        std::max(tally.WorstOpacity, std::abs(rays.truth(point, d, begin, length)[3] - threshold));
      const double expected = scalarAt(rays, point, d, length);
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
  expectPicks(imageOf(noise(1), unitCube(6)), LatticeValues::PointsLinear);
  expectPicks(imageOf(noise(2), unitCube(6)), LatticeValues::CellsLinear);
  expectPicks(rectilinearOf(noise(3), unevenCube(6)), LatticeValues::PointsLinear);
}
} // namespace
