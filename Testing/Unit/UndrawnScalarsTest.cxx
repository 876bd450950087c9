// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Vertices whose scalar isn't drawn take all tetrahedra around them out of the picture, however a
// ray comes by: exactly as if these were hidden.
#include "Mesh/HiddenCells.h"
#include "Reference/ExtremePointKernel.h"
#include "Reference/IsosurfacesPointKernel.h"
#include "Reference/LightRayPointKernel.h"
#include "Reference/PointKernel.h"
#include "Reference/PortablePointKernel.h"
#include "Reference/SumPointKernel.h"

#include "BlendedRays.h"
#include "RandomRays.h"
#include "RandomVolume.h"
#include "UnitMeshes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

HiddenCells cellsAround(const TetMesh& mesh, const std::vector<bool>& vertices)
{
  HiddenCells hidden(mesh.Tets.size() / 32 + 1, 0u);
  for (std::size_t t = 0; t < mesh.Tets.size(); ++t)
  {
    for (const Id v : mesh.Tets[t])
    {
      hidden[t / 32] |= vertices[v] ? 1u << t % 32 : 0u;
    }
  }
  return hidden;
}

// One in sixteen.
std::vector<bool> someVertices(const TetMesh& mesh, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<bool> chosen(mesh.Vertices.size());
  std::generate(chosen.begin(), chosen.end(), [&random] { return random() % 16 == 0; });
  return chosen;
}

void undraw(TetMesh& mesh, const std::vector<bool>& vertices)
{
  for (std::size_t v = 0; v < mesh.Vertices.size(); ++v)
  {
    mesh.Vertices[v].Scalar = vertices[v] ? UndrawnScalar : mesh.Vertices[v].Scalar;
  }
}

// Rays of every kind, most of them through vertices and edges. Returns how many see anything.
template <typename Kernel, typename Real>
int expectSamePictures(Kernel& undrawn, Kernel& hidden, const TetMesh& mesh)
{
  RandomRays rays(41);
  int seen = 0;
  for (int i = 0; i < 400; ++i)
  {
    const auto ray = rays.next<Kernel, Real>(undrawn, mesh);
    const auto cast = [&ray](Kernel& kernel)
    {
      const auto march = kernel.castPlainRay(ray, Real(3), Real(-1e30f), Real(1e30f));
      return kernel.pixelOf(march.radiance, Real(3));
    };
    const auto found = cast(undrawn);
    const auto expected = cast(hidden);
    EXPECT_EQ(found.x, expected.x) << static_cast<int>(rays.LastKind);
    EXPECT_EQ(found.y, expected.y);
    EXPECT_EQ(found.z, expected.z);
    EXPECT_EQ(found.w, expected.w);
    if (::testing::Test::HasFailure())
    {
      return seen;
    }
    seen += expected.w > Real(0) ? 1 : 0;
  }
  return seen;
}

template <typename Kernel, typename Real>
void expectComposites()
{
  int seen = 0;
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    TetMesh whole = builtWithHierarchy(named.Make());
    std::mt19937 random(5);
    for (Vertex& v : whole.Vertices)
    {
      v.Scalar = static_cast<float>(uniform(random));
    }
    const std::vector<bool> chosen = someVertices(whole, 7);
    TetMesh broken = whole;
    undraw(broken, chosen);
    const IntegralTable table = bumpyTable();
    Kernel undrawn = kernelOf<Kernel, Real>(broken, table, DefaultAccuracy);
    Kernel hidden = kernelOf<Kernel, Real>(whole, table, DefaultAccuracy);
    const HiddenCells cells = cellsAround(whole, chosen);
    hidden.HiddenCells = cells.data();
    seen += expectSamePictures<Kernel, Real>(undrawn, hidden, whole);
    ASSERT_FALSE(::testing::Test::HasFailure());
  }
  EXPECT_GT(seen, 1000);
}

TEST(UndrawnScalars, AreAsHiddenCellsInComposites)
{
  expectComposites<PointKernel<float>, float>();
  expectComposites<PointKernel<double>, double>();
  expectComposites<PortablePointKernel<float>, float>();
}

template <template <typename> class KernelOf, typename Real>
void expectBlended(BlendMode mode)
{
  using Kernel = KernelOf<Real>;
  SCOPED_TRACE(static_cast<int>(mode));
  const Grid grid = jitteredLattice(5, 0.0, 1, sineField());
  BlendedRays undrawn(grid), hidden(grid);
  const std::vector<bool> chosen = someVertices(hidden.Mesh, 7);
  undraw(undrawn.Mesh, chosen);
  for (BlendedRays* rays : { &undrawn, &hidden })
  {
    mode == BlendMode::IsoSurface ? rays->useSurfaces({ 0.3, 0.5, 0.6 }) : rays->use(mode);
  }
  Kernel broken = undrawn.kernel<Kernel>();
  Kernel whole = hidden.kernel<Kernel>();
  const HiddenCells cells = cellsAround(hidden.Mesh, chosen);
  whole.HiddenCells = cells.data();
  EXPECT_GT((expectSamePictures<Kernel, Real>(broken, whole, hidden.Mesh)), 100);
}

template <typename Real>
void expectBlendModes()
{
  expectBlended<ExtremePointKernel, Real>(BlendMode::Maximum);
  expectBlended<ExtremePointKernel, Real>(BlendMode::Minimum);
  expectBlended<SumPointKernel, Real>(BlendMode::Average);
  expectBlended<SumPointKernel, Real>(BlendMode::Additive);
  expectBlended<IsosurfacesPointKernel, Real>(BlendMode::IsoSurface);
}

TEST(UndrawnScalars, AreAsHiddenCellsInBlendModes)
{
  expectBlendModes<float>();
  expectBlendModes<double>();
}

// Along the edges of a lattice of cubes, where all that is drawn is transparent.
template <typename Real>
void expectNothingAlongEdges()
{
  using Kernel = PointKernel<Real>;
  constexpr int n = 3;
  TetMesh mesh = builtWithHierarchy(jitteredLattice(n, 0.0));
  const IntegralTable table = tableOf(
    [](double s) {
      return std::array<double, 4>{ { 1.0, 1.0, 1.0, s < 0.7 ? 1.0 : 0.0 } };
    });
  for (std::size_t broken = 0; broken < mesh.Vertices.size(); ++broken)
  {
    for (std::size_t v = 0; v < mesh.Vertices.size(); ++v)
    {
      mesh.Vertices[v].Scalar = v == broken ? UndrawnScalar : 0.75f;
    }
    Kernel kernel = kernelOf<Kernel, Real>(mesh, table, DefaultAccuracy);
    for (const Vertex& through : mesh.Vertices)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto ray = kernel.rayThrough({ Real(through.X), Real(through.Y), Real(through.Z) },
          { Real(axis == 0), Real(axis == 1), Real(axis == 2) });
        const auto march = kernel.castPlainRay(ray, Real(9), Real(-1e30f), Real(1e30f));
        ASSERT_EQ(march.radiance.transmittance, Real(1)) << "beside vertex " << broken;
      }
    }
  }
}

TEST(UndrawnScalars, GiveNoScalarToEdgesOppositeThem)
{
  expectNothingAlongEdges<float>();
  expectNothingAlongEdges<double>();
}

// With the colour and extinction of all else, such cells can't be seen.
TEST(UndrawnScalars, ShownAsTheRestAreNotSeen)
{
  using Kernel = PointKernel<double>;
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    TetMesh whole = builtWithHierarchy(named.Make());
    for (Vertex& v : whole.Vertices)
    {
      v.Scalar = 0.5f;
    }
    TetMesh broken = whole;
    undraw(broken, someVertices(whole, 7));
    Kernel expected = kernelOf<Kernel, double>(whole, whiteTable(), DefaultAccuracy);
    Kernel found = kernelOf<Kernel, double>(broken, whiteTable(), DefaultAccuracy);
    found.nanColor = { 1.0, 1.0, 1.0, 1.0 };
    RandomRays rays(43);
    for (int i = 0; i < 200; ++i)
    {
      const auto ray = rays.next<Kernel, double>(found, whole);
      const auto a = expected.castPlainRay(ray, 2.0, -1e30, 1e30).radiance;
      const auto b = found.castPlainRay(ray, 2.0, -1e30, 1e30).radiance;
      ASSERT_NEAR(b.transmittance, a.transmittance, 1e-6);
      ASSERT_NEAR(b.color.x, a.color.x, 1e-6);
    }
  }
}

// The same for rays towards the light.
TEST(UndrawnScalars, AreAsHiddenCellsInExtinction)
{
  using Kernel = LightRayPointKernel<double>;
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    RandomVolume<Kernel> whole(named.Make(), false);
    RandomVolume<Kernel> broken(named.Make(), false);
    const std::vector<bool> chosen = someVertices(whole.Mesh, 7);
    for (Vertex& v : whole.Mesh.Vertices)
    {
      v.Scalar = std::min(v.Scalar, 0.5f);
    }
    broken.Mesh.Vertices = whole.Mesh.Vertices;
    undraw(broken.Mesh, chosen);
    whole.Hidden = cellsAround(whole.Mesh, chosen);
    whole.March.HiddenCells = whole.Hidden.data();
    broken.March.HiddenCells = nullptr;
    broken.March.nanColor.w = 0.0;
    RandomRays rays(47);
    for (int i = 0; i < 200; ++i)
    {
      const auto ray = rays.next<Kernel, double>(whole.March, whole.Mesh);
      const auto cast = [&ray](RandomVolume<Kernel>& volume)
      {
        auto traversal = volume.March.traversalFrom(ray, 0);
        return volume.March.transmittanceOn(ray, 4.0, -1e30, 1e30, traversal);
      };
      ASSERT_EQ(cast(broken), cast(whole));
    }
  }
}
} // namespace
