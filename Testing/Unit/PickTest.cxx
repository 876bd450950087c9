// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Where rays are picked, against the march of the picture that ends there.
#include "RandomRays.h"
#include "RandomVolume.h"
#include "UnitMeshes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

struct Tally
{
  int Hits = 0;
  int Misses = 0;
  int Compared = 0;
  double Worst = 0.0; // difference of transmittance
  double Least = 1.0; // barycentric coordinate of a point in its tetrahedron
};

glsl::Vec3<double> place(const TetMesh& mesh, Id vertex)
{
  const Vertex& v = mesh.Vertices[vertex];
  return { v.X, v.Y, v.Z };
}

// The least barycentric coordinate.
double depthInside(const TetMesh& mesh, Id tet, glsl::Vec3<double> point)
{
  const auto volumeOf = [](const std::array<glsl::Vec3<double>, 4>& p)
  { return glsl::dot(p[1] - p[0], glsl::cross(p[2] - p[0], p[3] - p[0])); };
  std::array<glsl::Vec3<double>, 4> corners;
  for (int i = 0; i < 4; ++i)
  {
    corners[i] = place(mesh, mesh.Tets[tet][i]);
  }
  const double whole = volumeOf(corners);
  double least = 1.0;
  for (int i = 0; i < 4; ++i)
  {
    auto moved = corners;
    moved[i] = point;
    least = std::min(least, volumeOf(moved) / whole);
  }
  return least;
}

// The opacity up to the point is the threshold; with gradients that change in a cell the march of
// the picture takes other means than a part of it, so that only the tetrahedron is certain.
template <typename Kernel>
void pickRays(RandomVolume<Kernel>& volume, bool exact, Tally& tally)
{
  Kernel& kernel = volume.March;
  RandomRays rays(29);
  for (int i = 0; i < 400; ++i)
  {
    const auto ray = rays.next<Kernel, double>(kernel, volume.Mesh);
    const double length = volume.nextLength();
    const double left = i % 5 == 0 ? 1.0 : rays.uniformBetween(0.01, 1.0); // of the light
    const double begin = i % 3 == 0 ? rays.uniformBetween(-1.0, 0.5) : -1e30;
    const double end = i % 4 == 0 ? rays.uniformBetween(-0.5, 1.0) : 1e30;
    kernel.errorTolerance = 1e-9;
    const double all = kernel.castPlainRay(ray, -1, length, begin, end).radiance.transmittance;
    kernel.errorTolerance = left;
    auto way = kernel.wayFromBoundary(ray, -1);
    const auto pick = kernel.pickOn(ray, length, begin, end, way);
    if (std::abs(all - left) > 1e-6)
    {
      ASSERT_EQ(pick.hit, all < left) << all << " of " << left;
    }
    if (!pick.hit)
    {
      ++tally.Misses;
      continue;
    }
    ++tally.Hits;
    ASSERT_LT(pick.tet, volume.Mesh.numberOfTets());
    ASSERT_GE(pick.depth, begin);
    ASSERT_LE(pick.depth, end);
    tally.Least = std::min(
      tally.Least, depthInside(volume.Mesh, pick.tet, ray.origin + ray.direction * pick.depth));
    kernel.errorTolerance = 1e-9;
    const auto before = kernel.castPlainRay(ray, -1, length, begin, pick.depth);
    // Along an edge beside one that isn't drawn, a scalar depends on the order of the corners.
    if (exact && rays.LastKind == RandomRays::Kind::Generic)
    {
      ++tally.Compared;
      tally.Worst = std::max(tally.Worst, std::abs(before.radiance.transmittance - left));
    }
  }
}

template <typename Kernel>
void pickIn(bool cellGradients, bool evenDensity, const char* which)
{
  Tally tally;
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    RandomVolume<Kernel> volume(named.Make(), cellGradients);
    if (evenDensity)
    {
      volume.Effects.GradientOpacity.Values = { 1.0f, 1.0f, 1.0f, 1.0f };
    }
    ASSERT_NO_FATAL_FAILURE(pickRays(volume, evenDensity || cellGradients, tally));
  }
  EXPECT_GT(tally.Hits, 1000);
  EXPECT_GT(tally.Misses, 1000);
  // What tables lose to fixed point, and exponentials by a series of each cell.
  EXPECT_EQ(tally.Compared > 1000, evenDensity || cellGradients);
  EXPECT_LE(tally.Worst, 1e-7) << which;
  EXPECT_GE(tally.Least, -1e-6) << which;
  std::cout << "[ MEASURED ] " << which << ": " << tally.Hits << " hits, " << tally.Misses
            << " misses, transmittance within " << tally.Worst << ", least coordinate "
            << tally.Least << '\n';
}

TEST(Pick, OfPointScalars)
{
  pickIn<LightRayKernel<double>>(false, true, "point scalars");
  pickIn<LightRayKernel<double>>(false, false, "with opacity by gradients of vertices");
}

TEST(Pick, OfCellScalars) { pickIn<LightRayCellKernel<double>>(false, true, "cell scalars"); }

TEST(Pick, WithGradientsOfCells)
{
  pickIn<LightRayCellGradientKernel<double>>(true, false, "with opacity by gradients of cells");
}

// In closed form, in float: a transmittance of `left` after a length of -ln(left) / extinction.
TEST(Pick, InEvenExtinctionByFloats)
{
  using Kernel = LightRayKernel<float>;
  const TetMesh mesh = builtWithHierarchy(jitteredLattice(6, 0.15));
  EffectData effects;
  effects.Gradients.resize(mesh.Vertices.size());
  effects.GradientOpacity.Values = { 1.0f, 1.0f };
  effects.GradientOpacityScale = 1.0;
  const IntegralTable table = tableOf(
    [](double) {
      return std::array<double, 4>{ { 1.0, 1.0, 1.0, 0.5 } };
    });
  auto kernel = kernelOf<Kernel, float>(mesh, table, LightAccuracy);
  kernel.useEffects(effects);
  RandomRays rays(31);
  int hits = 0;
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i)
  {
    const auto ray = rays.next<Kernel, float>(kernel, mesh);
    kernel.errorTolerance = static_cast<float>(rays.uniformBetween(0.05, 0.95));
    const float length = static_cast<float>(rays.uniformBetween(1.0, 20.0));
    auto way = kernel.wayFromBoundary(ray, -1);
    const float entry = way.entry.depth;
    const auto pick = kernel.pickOn(ray, length, -1e30f, 1e30f, way);
    if (pick.hit)
    {
      const double expected = -std::log(double(kernel.errorTolerance)) / (0.5 * double(length));
      worst = std::max(worst, std::abs(double(pick.depth - entry) - expected));
      ++hits;
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_LE(worst, 2e-5);
  std::cout << "[ MEASURED ] " << hits << " points in even extinction within " << worst
            << " of the mesh's radius\n";
}
} // namespace
