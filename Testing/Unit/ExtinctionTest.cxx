// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The march that knows extinction alone against the one that knows everything.
#include "Mesh/HiddenCells.h"
#include "Mesh/VertexStarts.h"
#include "Reference/LitKernel.h"

#include "RandomRays.h"
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

// Ramps, steps and spikes of a bin.
IntegralTable bumpyTable()
{
  return tableOf(
    [](double f)
    {
      const int sample = static_cast<int>(std::lround(1023.0 * f));
      const double extinction = sample % 37 == 0 ? 1.0 : sample % 256 < 128 ? 0.3 * f : 0.05;
      return std::array<double, 4>{ { 1.0, 1.0, 1.0, extinction } };
    });
}

// A mesh of random scalars and gradients, and how thick it is.
template <typename Kernel>
struct Volume
{
  Volume(vtkUnstructuredGrid* grid, bool cellGradients)
    : Mesh(builtWithHierarchy(grid))
    , Starts(vertexStarts(Mesh))
    , CellScalars(Mesh.numberOfTets())
  {
    // One in 64 isn't drawn, and at points many are alike.
    const auto scalar = [&]
    {
      const double x = uniform(this->Random);
      return this->Random() % 64 == 0 ? UndrawnScalar
                                      : static_cast<float>(x < 0.3 ? 0.25 + 1e-6 * x : x);
    };
    std::generate(this->CellScalars.begin(), this->CellScalars.end(), scalar);
    for (Vertex& v : this->Mesh.Vertices)
    {
      v.Scalar = scalar();
    }
    this->Effects.CellGradients = cellGradients;
    this->Effects.Gradients.resize(
      cellGradients ? this->Mesh.Tets.size() : this->Mesh.Vertices.size());
    for (auto& gradient : this->Effects.Gradients)
    {
      for (float& x : gradient)
      {
        x = static_cast<float>(uniform(this->Random));
      }
    }
    this->Effects.GradientOpacity.Values = { 0.0f, 1.0f, 0.2f, 0.7f };
    this->Effects.GradientOpacityScale = 3.0;
    this->March = kernelOf<Kernel, double>(this->Mesh, this->Table, LightAccuracy);
    this->March.CellScalars = this->CellScalars.data();
    // Two in 32 tetrahedra are hidden, and what isn't finite has an extinction.
    this->Hidden.resize(this->CellScalars.size() / 32 + 1);
    std::generate(this->Hidden.begin(), this->Hidden.end(),
      [&] { return 1u << this->Random() % 32 | 1u << this->Random() % 32; });
    this->March.HiddenCells = this->Hidden.data();
    this->March.nanColor = { 0.1, 0.2, 0.3, 0.4 };
    this->March.useEffects(this->Effects);
    this->March.useLightRays(this->Effects.Lights, this->Camera);
  }

  // So many scalar opacity unit distances are a unit of depth.
  double nextLength()
  {
    const double length = std::pow(10.0, 3.0 * uniform(this->Random) - 1.0);
    this->Camera.LengthMatrix = { { length, 0, 0, 0, length, 0, 0, 0, length } };
    return length;
  }

  glsl::Vec3<double> nextDirection()
  {
    std::normal_distribution<double> normal;
    return glsl::normalize(
      glsl::Vec3<double>(normal(this->Random), normal(this->Random), normal(this->Random)));
  }

  // Somewhere in the tetrahedron.
  glsl::Vec3<double> nextPoint(const std::array<Id, 4>& corners)
  {
    glsl::Vec3<double> point(0, 0, 0);
    double sum = 0.0;
    for (const Id corner : corners)
    {
      const double share = 0.05 + uniform(this->Random);
      const Vertex& v = this->Mesh.Vertices[corner];
      point = point + glsl::Vec3<double>(v.X, v.Y, v.Z) * share;
      sum += share;
    }
    return point * (1.0 / sum);
  }

  std::mt19937 Random{ 17 };
  TetMesh Mesh;
  std::vector<std::array<Id, 4>> Starts;
  std::vector<float> CellScalars;
  HiddenCells Hidden;
  const IntegralTable Table = bumpyTable();
  EffectData Effects;
  View Camera;
  Kernel March;
};

struct Tally
{
  double Worst = 0.0; // difference, a cell
  int Rays = 0;       // that some light comes along, but not all
};

// The march of the picture takes an exponential a cell, by a series that is good to 4e-8; and where
// either has ended for darkness, the other may be darker still.
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

// All ways from boundary to boundary, or a part of the ray.
template <typename Kernel>
void compareRays(Volume<Kernel>& volume, Tally& tally)
{
  Kernel& kernel = volume.March;
  RandomRays rays(23);
  for (int i = 0; i < 300; ++i)
  {
    const auto ray = rays.next<Kernel, double>(kernel, volume.Mesh);
    const double length = volume.nextLength();
    const double begin = i % 3 == 0 ? rays.uniformBetween(-1.0, 0.5) : -1e30;
    const double end = i % 4 == 0 ? rays.uniformBetween(-0.5, 1.0) : 1e30;
    auto way = kernel.wayFromBoundary(ray, -1);
    const double found = kernel.transmittanceOn(ray, length, begin, end, way);
    ASSERT_NO_FATAL_FAILURE(
      expectSame(found, kernel.castPlainRay(ray, -1, length, begin, end), tally));
  }
}

// From points inside, whose way the other march looks for in the hierarchy.
template <typename Kernel>
void compareRaysFromInside(Volume<Kernel>& volume, Tally& tally)
{
  Kernel& kernel = volume.March;
  for (int i = 0; i < 300; ++i)
  {
    const Id vertex = static_cast<Id>(volume.Random() % volume.Mesh.Vertices.size());
    const auto& start = volume.Starts[vertex];
    typename Kernel::Tet tet;
    tet.number = start[3];
    tet.a = vertex;
    tet.b = start[0];
    tet.c = start[1];
    tet.d = start[2];
    const auto point = volume.nextPoint({ { tet.a, tet.b, tet.c, tet.d } });
    const auto direction = volume.nextDirection();
    const double length = volume.nextLength();
    const double distance = i % 2 == 0 ? uniform(volume.Random) : 1e30;
    const double found = kernel.transmittanceTowards(tet, point, direction, distance);
    const auto ray = kernel.rayThrough(point, direction);
    const double begin = glsl::dot(point - ray.origin, ray.direction);
    ASSERT_NO_FATAL_FAILURE(
      expectSame(found, kernel.castPlainRay(ray, -1, length, begin, begin + distance), tally));
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
    Volume<Kernel> volume(named.Make(), cellGradients);
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

// Where tetrahedra overlap, who comes from inside has seen less.
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
  compareMarches<LightRayKernel<double>>(false);
  compareFromInside<LightRayKernel<double>>(false);
}

TEST(Extinction, OfCellScalarsIsThatOfThePicture)
{
  compareMarches<LightRayCellKernel<double>>(false);
  compareFromInside<LightRayCellKernel<double>>(false);
}

TEST(Extinction, WithGradientsOfCellsIsThatOfThePicture)
{
  compareMarches<LightRayCellGradientKernel<double>>(true);
  compareFromInside<LightRayCellGradientKernel<double>>(true);
}
} // namespace
