// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Where rays are picked, against the march of the picture that ends there.
#include "Reference/PickCellKernel.h"
#include "Reference/PickPointGradientKernel.h"
#include "Reference/PickPointKernel.h"

#include "CutLine.h"
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
  int Cropped = 0;    // of the hits
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

// In units of the mesh's radius: planes in the middle, and other regions from ray to ray.
ClippingOptions croppingOf(int flags)
{
  ClippingOptions options;
  options.Cropping = true;
  options.CroppingPlanes = { { -0.21, 0.17, -0.13, 0.24, -0.16, 0.19 } };
  options.CroppingFlags = flags;
  return options;
}

template <typename Kernel>
void useCropping(Kernel& kernel, const ClippingOptions& options, Clipping& clipping)
{
  const auto& p = options.CroppingPlanes;
  clipping.Cropped = true;
  clipping.CroppingLow = { { p[0], p[2], p[4] } };
  clipping.CroppingHigh = { { p[1], p[3], p[5] } };
  clipping.CroppingFlags = options.CroppingFlags;
  kernel.useClipping(clipping);
}

// The opacity up to the point is the threshold, and the point is in a region that is left.
template <typename Kernel>
void pickRays(RandomVolume<Kernel>& volume, Tally& tally)
{
  Kernel& kernel = volume.March;
  RandomRays rays(29);
  const std::vector<int> flags = croppingFlagsToTest();
  for (int i = 0; i < 400; ++i)
  {
    const ClippingOptions options =
      croppingOf(i % 2 ? Clipping::AllRegions : flags[i / 2 % flags.size()]);
    Clipping clipping;
    useCropping(kernel, options, clipping);
    const auto ray = rays.next<Kernel, double>(kernel, volume.Mesh);
    const double length = volume.nextLength();
    const double left = i % 5 == 0 ? 1.0 : rays.uniformBetween(0.01, 1.0); // of the light
    const double begin = i % 3 == 0 ? rays.uniformBetween(-1.0, 0.5) : -1e30;
    const double end = i % 4 == 0 ? rays.uniformBetween(-0.5, 1.0) : 1e30;
    const auto transmittanceTo = [&](double depth)
    { return kernel.castPlainRay(ray, length, begin, depth).radiance.transmittance; };
    const double all = transmittanceTo(end);
    kernel.errorTolerance = left; // as the mapper has it
    const auto pick = kernel.pickOn(ray, length, begin, end, left);
    kernel.errorTolerance = 1e-9;
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
    ASSERT_LT(pick.cell, volume.Mesh.numberOfTets());
    ASSERT_GE(pick.depth, begin);
    ASSERT_LE(pick.depth, end);
    const auto point = ray.origin + ray.direction * pick.depth;
    tally.Least = std::min(tally.Least, depthInside(volume.Mesh, pick.cell, point));
    tally.Worst = std::max(tally.Worst, std::abs(transmittanceTo(pick.depth) - left));
    // A little before it, for it may lie in a plane.
    const auto before = ray.origin + ray.direction * (pick.depth - 1e-9);
    ASSERT_TRUE(!isCroppedAway(options, { before.x, before.y, before.z }) ||
                !isCroppedAway(options, { point.x, point.y, point.z }));
    tally.Cropped += i % 2 ? 0 : 1;
  }
}

template <typename Kernel>
void pickIn(bool cellGradients, const char* which)
{
  Tally tally;
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    RandomVolume<Kernel> volume(named.Make(), cellGradients);
    ASSERT_NO_FATAL_FAILURE(pickRays(volume, tally));
  }
  EXPECT_GT(tally.Hits, 1000);
  EXPECT_GT(tally.Misses, 1000);
  EXPECT_GT(tally.Cropped, 500);
  // A threshold of 0 is where the first light is lost.
  EXPECT_LE(tally.Worst, 1e-7) << which;
  EXPECT_GE(tally.Least, -1e-6) << which;
  std::cout << "[ MEASURED ] " << which << ": " << tally.Hits << " hits, " << tally.Misses
            << " misses, transmittance within " << tally.Worst << ", least coordinate "
            << tally.Least << '\n';
}

TEST(Pick, OfPointScalars) { pickIn<PickPointKernel<double>>(false, "point scalars"); }

TEST(Pick, OfCellScalars) { pickIn<PickCellKernel<double>>(false, "cell scalars"); }

TEST(Pick, WithGradientsOfCells)
{
  pickIn<PickPointGradientKernel<double>>(true, "gradients of cells");
}

// In closed form, in float: a transmittance of `left` after a length of -ln(left) / extinction.
TEST(Pick, InEvenExtinctionByFloats)
{
  using Kernel = PickPointKernel<float>;
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
    const float left = static_cast<float>(rays.uniformBetween(0.05, 0.95));
    const float length = static_cast<float>(rays.uniformBetween(1.0, 20.0));
    const float entry = kernel.traversalFrom(ray, 0).entry.depth;
    const auto pick = kernel.pickOn(ray, length, -1e30f, 1e30f, left);
    if (pick.hit)
    {
      const double expected = -std::log(double(left)) / (0.5 * double(length));
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
