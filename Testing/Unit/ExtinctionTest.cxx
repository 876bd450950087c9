// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march that gathers extinction alone against the march of the picture.
#include "Reference/LightRayCellKernel.h"
#include "Reference/LightRayPointGradientKernel.h"
#include "Reference/LightRayPointKernel.h"

#include "RandomRays.h"
#include "RandomVolume.h"
#include "UnitMeshes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <random>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

struct Tally
{
  double Worst = 0.0; // difference for each cell of a ray
  int Rays = 0;       // along which some light is lost
};

// The march of the picture takes an exponential for each cell, by a series that is good to 4e-8.
// Either march ends when its transmittance is below the tolerance; then the other may be smaller.
template <typename March>
void expectSame(double found, const March& march, Tally& tally)
{
  const double expected = march.radiance.transmittance;
  if (std::max(found, expected) < LightAccuracy.ErrorTolerance * (1.0 + 1e-5))
  {
    return;
  }
  const double difference = std::abs(found - expected);
  ASSERT_LE(difference, 5e-8 * (march.cells + 1)) << found << " for " << expected;
  tally.Worst = std::max(tally.Worst, difference / (march.cells + 1));
  tally.Rays += found < 0.99 ? 1 : 0;
}

// All that a ray meets from boundary to boundary, or on a part of it.
template <typename Kernel>
void compareRays(RandomVolume<Kernel>& volume, Tally& tally)
{
  Kernel& kernel = volume.March;
  RandomRays rays(23);
  for (int i = 0; i < 300; ++i)
  {
    const auto ray = rays.next<Kernel, double>(kernel, volume.Mesh);
    const double length = volume.nextLength();
    const double begin = i % 3 == 0 ? rays.uniformBetween(-1.0, 0.5) : -1e30;
    const double end = i % 4 == 0 ? rays.uniformBetween(-0.5, 1.0) : 1e30;
    auto traversal = kernel.traversalFrom(ray, 0);
    const double found = kernel.transmittanceOn(ray, length, begin, end, traversal);
    ASSERT_NO_FATAL_FAILURE(expectSame(found, kernel.castPlainRay(ray, length, begin, end), tally));
  }
}

// From points inside; the march that it is compared with searches the hierarchy for its entry.
template <typename Kernel>
void compareRaysFromInside(RandomVolume<Kernel>& volume, Tally& tally)
{
  Kernel& kernel = volume.March;
  kernel.useLightRays(volume.Effects.Lights, volume.Camera);
  for (int i = 0; i < 300; ++i)
  {
    const Id vertex = static_cast<Id>(volume.Random() % volume.Mesh.Vertices.size());
    const auto& start = volume.Starts[vertex];
    typename Kernel::LightStart from;
    from.side = { 4 * start[3] + 3, start[2] };
    from.ids = { vertex, start[0], start[1] };
    from.point = volume.nextPoint(
      { { vertex, start[0], start[1], fourthVertex(volume.Mesh, vertex, start) } });
    const auto direction = volume.nextDirection();
    const double length = volume.nextLength();
    const double distance = i % 2 == 0 ? uniform(volume.Random) : 1e30;
    const double found = kernel.transmittanceTo(from, direction, distance);
    const auto ray = kernel.rayThrough(from.point, direction);
    const double begin = glsl::dot(from.point - ray.origin, ray.direction);
    ASSERT_NO_FATAL_FAILURE(
      expectSame(found, kernel.castPlainRay(ray, length, begin, begin + distance), tally));
  }
}

template <typename Kernel, typename Compare>
void compareOf(const std::vector<NamedGrid>& grids, bool cellGradients, const char* which,
  const Compare& compare)
{
  Tally tally;
  for (const NamedGrid& named : grids)
  {
    SCOPED_TRACE(named.Name);
    RandomVolume<Kernel> volume(named.Make(), cellGradients);
    ASSERT_NO_FATAL_FAILURE(compare(volume, tally));
  }
  EXPECT_GT(tally.Rays, 500);
  std::cout << "[ MEASURED ] " << tally.Rays << " rays " << which << ": within " << tally.Worst
            << " a cell\n";
}

template <typename Kernel>
void compareMarches(bool cellGradients)
{
  std::vector<NamedGrid> grids = everyGrid();
  grids.push_back({ "tangled", [] { return jitteredLattice(5, 0.6); } });
  grids.push_back({ "more tangled", [] { return jitteredLattice(5, 1.5); } });
  compareOf<Kernel>(grids, cellGradients, "from the boundary", compareRays<Kernel>);
}

// Where tetrahedra overlap, a ray from inside has met fewer of them.
template <typename Kernel>
void compareFromInside(bool cellGradients)
{
  const std::vector<NamedGrid> grids = { { "lattice", [] { return jitteredLattice(5, 0.15); } },
    { "hole", [] { return latticeWithHole(6); } },
    { "tunnel", [] { return latticeWithTunnel(6); } },
    { "two components", [] { return twoComponents(4); } },
    { "shells", [] { return nestedShells(8); } },
    { "mixed cells", [] { return mixedCells(4, 1, 0.1); } } };
  compareOf<Kernel>(grids, cellGradients, "from inside", compareRaysFromInside<Kernel>);
}

TEST(Extinction, OfPointScalarsIsThatOfThePicture)
{
  compareMarches<LightRayPointKernel<double>>(false);
  compareFromInside<LightRayPointKernel<double>>(false);
}

TEST(Extinction, OfCellScalarsIsThatOfThePicture)
{
  compareMarches<LightRayCellKernel<double>>(false);
  compareFromInside<LightRayCellKernel<double>>(false);
}

TEST(Extinction, WithGradientsOfCellsIsThatOfThePicture)
{
  compareMarches<LightRayPointGradientKernel<double>>(true);
  compareFromInside<LightRayPointGradientKernel<double>>(true);
}
} // namespace
