// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The traversal of lattices: no ray skips or repeats a cell, whatever it runs along, and leaps
// leave out nothing that is seen.
//
// TETMARCH_RAYS in the environment takes the place of the number of rays through each lattice by
// each kernel, as in ./tetmarch stress.
#include "Reference/LeapingKernel.h"
#include "Reference/TrilinearKernel.h"
#include "Reference/UniformKernel.h"

#include "StructuredRays.h"

#include "Fields.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

long numberOfRays(long otherwise)
{
  const char* value = std::getenv("TETMARCH_RAYS");
  return value ? std::atol(value) : otherwise;
}

// The sum of what becomes of rays, by threads: `march(random, rays)` for each chunk of them.
template <typename Totals, typename March>
Totals sumOfRays(long count, unsigned seed, const March& march)
{
  constexpr long chunkRays = 4096;
  vtkSMPThreadLocal<Totals> ofThreads;
  vtkSMPTools::For(0, (count + chunkRays - 1) / chunkRays,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType chunk = begin; chunk < end; ++chunk)
      {
        std::mt19937 random(2654435761u * static_cast<unsigned>(chunk) + seed);
        ofThreads.Local() += march(random, std::min<long>(chunkRays, count - chunk * chunkRays));
      }
    });
  Totals sum;
  for (const Totals& totals : ofThreads)
  {
    sum += totals;
  }
  return sum;
}

struct Faults
{
  long Gaps = 0;    // a cell does not begin where the last one ended
  long Outside = 0; // the middle of an interval is not in its cell
  long Early = 0;   // the ray left before the end of the lattice
  long Endless = 0;
  long Crossed = 0; // cells

  Faults& operator+=(const Faults& other)
  {
    this->Gaps += other.Gaps;
    this->Outside += other.Outside;
    this->Early += other.Early;
    this->Endless += other.Endless;
    this->Crossed += other.Crossed;
    return *this;
  }
};

// A ray whose points and directions tie: through lattice points, along axes, in planes of cells.
template <typename Kernel, typename Real>
typename Kernel::Ray hardRay(const StructuredRays& rays, Kernel& kernel, std::mt19937& random)
{
  tetmarch::testing::Vec3 point = rays.pointNear(random, 1.05);
  const tetmarch::testing::Vec3 d = randomDirection(random);
  if (random() % 2)
  {
    // Onto planes of the lattice, along some axes.
    for (int k = 0; k < 3; ++k)
    {
      const LatticeAxis& axis = rays.Cells.Axes[k];
      const double plane = axis.plane(static_cast<int>(random() % (axis.Cells + 1)));
      const double half = axis.plane(axis.Cells);
      point[k] = random() % 3 ? rays.Cells.Frame.HalfExtent[k] * plane / half : point[k];
    }
  }
  return kernel.rayThrough(
    { Real(point[0]), Real(point[1]), Real(point[2]) }, { Real(d[0]), Real(d[1]), Real(d[2]) });
}

template <typename Kernel, typename Real>
Faults faultsOf(const StructuredRays& rays, std::mt19937& random, long count)
{
  auto kernel = rays.kernel<Kernel>();
  Faults faults;
  const double rounding = std::is_same_v<Real, float> ? 2e-4 : 1e-9; // of a cell
  for (long n = 0; n < count; ++n)
  {
    const auto ray = hardRay<Kernel, Real>(rays, kernel, random);
    const auto lattice = kernel.depthsOfLattice(ray);
    auto traversal = kernel.traversalFrom(ray, Real(-1e30));
    if (!kernel.continuesBefore(traversal, Real(1e30)))
    {
      faults.Early += lattice.x < lattice.y ? 1 : 0;
      continue;
    }
    auto cell = kernel.beginCellInterval(ray, traversal.place);
    Real end = cell.leave.x;
    bool onward = true;
    int cells = 0;
    int steps = 0;
    while (onward && steps <= kernel.mostSteps)
    {
      ++steps;
      const auto number = traversal.place.cell;
      const auto crossing = kernel.crossCell(ray, traversal.place, cell);
      onward = crossing.onward;
      cells += crossing.cells;
      faults.Gaps += cell.enter.x == end ? 0 : 1;
      end = std::max(end, cell.leave.x);
      const Real middle = Real(0.5) * (cell.enter.x + cell.leave.x);
      const double place[3] = { double(ray.start.x + ray.slope.x * middle),
        double(ray.start.y + ray.slope.y * middle), double(ray.start.z + ray.slope.z * middle) };
      const int numbers[3] = { number.x, number.y, number.z };
      for (int k = 0; k < 3; ++k)
      {
        const LatticeAxis& axis = rays.Cells.Axes[k];
        faults.Outside += place[k] < axis.plane(numbers[k]) - rounding ||
                              place[k] > axis.plane(numbers[k] + 1) + rounding
                            ? 1
                            : 0;
      }
    }
    // A cell has up to nine parts.
    faults.Endless += steps > kernel.mostSteps || cells > kernel.mostSteps / 9 ? 1 : 0;
    faults.Early += end == lattice.y ? 0 : 1;
    faults.Crossed += cells;
  }
  return faults;
}

template <typename Kernel, typename Real>
void expectSound(const StructuredRays& rays, unsigned seed)
{
  const long count = numberOfRays(100000);
  const auto faults = sumOfRays<Faults>(count, seed,
    [&rays](std::mt19937& random, long some)
    { return faultsOf<Kernel, Real>(rays, random, some); });
  EXPECT_EQ(faults.Gaps, 0);
  EXPECT_EQ(faults.Outside, 0);
  EXPECT_EQ(faults.Early, 0);
  EXPECT_EQ(faults.Endless, 0);
  EXPECT_GT(faults.Crossed, count);
  std::cout << "[ MEASURED ] " << count << " rays, " << faults.Crossed << " cells\n";
}

TEST(StructuredTraversal, CrossesEachCellOnce)
{
  const OpticalModel model = rampAndPeak(0.1);
  const StructuredRays cube(
    imageOf(productField(), unitCube(16)), LatticeValues::PointsLinear, model);
  expectSound<UniformKernel<float>, float>(cube, 1);
  expectSound<UniformKernel<double>, double>(cube, 2);
  expectSound<TrilinearKernel<float>, float>(cube, 3);
  const StructuredRays centred(
    imageOf(productField(), unitCube(7)), LatticeValues::CellsLinear, model);
  expectSound<UniformKernel<float>, float>(centred, 4);
}

TEST(StructuredTraversal, CrossesEachCellOfUnevenGridsOnce)
{
  const StructuredRays uneven(
    rectilinearOf(productField(), unevenCube(12)), LatticeValues::PointsLinear, rampAndPeak(0.1));
  expectSound<TrilinearKernel<float>, float>(uneven, 5);
  expectSound<TrilinearKernel<double>, double>(uneven, 6);
}

struct Leaps
{
  long Different = 0; // rays
  long Seen = 0;      // rays that most light is taken from
  long Leapt = 0;     // cells that were crossed with leaps
  long Stepped = 0;   // and without

  Leaps& operator+=(const Leaps& other)
  {
    this->Different += other.Different;
    this->Seen += other.Seen;
    this->Leapt += other.Leapt;
    this->Stepped += other.Stepped;
    return *this;
  }
};

Leaps leapsOf(
  const StructuredRays& rays, const BlockDistances& empty, std::mt19937& random, long count)
{
  auto leaping = rays.kernel<LeapingKernel<double>>();
  leaping.useEmptySpace(empty);
  auto stepping = rays.kernel<UniformKernel<double>>();
  Leaps leaps;
  for (long n = 0; n < count; ++n)
  {
    const auto ray = hardRay<LeapingKernel<double>, double>(rays, leaping, random);
    const auto same = stepping.rayThrough({ ray.origin.x, ray.origin.y, ray.origin.z },
      { ray.direction.x, ray.direction.y, ray.direction.z });
    const auto found = leaping.castPlainRay(ray, rays.perDepth(), -1e30, 1e30);
    const auto expected = stepping.castPlainRay(same, rays.perDepth(), -1e30, 1e30);
    // Rounding decides where subsegments end: they are the same but for the tolerance.
    const auto alike = [](double a, double b) { return std::abs(a - b) <= 1e-6; };
    leaps.Different += alike(found.radiance.transmittance, expected.radiance.transmittance) &&
                           alike(found.radiance.color.x, expected.radiance.color.x)
                         ? 0
                         : 1;
    leaps.Seen += expected.radiance.transmittance < 0.5 ? 1 : 0;
    leaps.Leapt += found.cells;
    leaps.Stepped += expected.cells;
  }
  return leaps;
}

// A small ball in an empty volume.
TEST(StructuredTraversal, LeapsLeaveOutNothing)
{
  const Field ball = [](double x, double y, double z)
  { return std::max(0.0, 1.0 - 8.0 * std::hypot(x - 0.3, y - 0.6, z - 0.5)); };
  OpticalModel model = rampAndPeak(0.02);
  model.Opacity->RemoveAllPoints();
  model.Opacity->AddPoint(0.1, 0.0);
  model.Opacity->AddPoint(1.0, 0.9);
  const StructuredRays rays(imageOf(ball, unitCube(40)), LatticeValues::PointsLinear, model);
  const BlockDistances empty = findBlockDistances(
    findBlockRanges(rays.Cells, rays.Values[0]), rays.Table, rays.Values[0].Range, false);
  EXPECT_GT(empty.EmptyShare, 0.8);
  const auto leaps = sumOfRays<Leaps>(numberOfRays(20000), 7,
    [&](std::mt19937& random, long some) { return leapsOf(rays, empty, random, some); });
  EXPECT_EQ(leaps.Different, 0);
  EXPECT_GT(leaps.Seen, 100);
  EXPECT_LT(3 * leaps.Leapt, leaps.Stepped);
}
} // namespace
