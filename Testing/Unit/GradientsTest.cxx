// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Gradients of linear fields are exact; cells that aren't drawn, or are flat, take no part in them.
#include "Mesh/Gradients.h"
#include "Mesh/Orientation.h"
#include "Mesh/VertexTets.h"

#include "UnitMeshes.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <string>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr Gradient Slope{ { 0.2f, -0.3f, 0.1f } };

float linear(double x, double y, double z)
{
  return static_cast<float>(0.5 + 0.2 * x - 0.3 * y + 0.1 * z);
}

TetMesh linearMesh(const Grid& grid)
{
  TetMesh mesh = built(grid);
  for (Vertex& v : mesh.Vertices)
  {
    v.Scalar = linear(double(v.X), double(v.Y), double(v.Z));
  }
  return mesh;
}

double difference(const Gradient& a, const Gradient& b)
{
  double most = 0;
  for (int k = 0; k < 3; ++k)
  {
    most = std::max(most, std::abs(double(a[k]) - double(b[k])));
  }
  return most;
}

// At each vertex, of tetrahedra that have a volume.
std::vector<bool> verticesWithVolume(const TetMesh& mesh)
{
  std::vector<bool> known(mesh.Vertices.size(), false);
  for (Id t = 0; t < mesh.numberOfTets(); ++t)
  {
    for (const Id v : mesh.Tets[t])
    {
      known[v] = known[v] || volumeSign(mesh, t) != 0;
    }
  }
  return known;
}

TEST(Gradients, OfLinearFieldsAreExact)
{
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    if (std::string(named.Name) == "squashed lattice")
    {
      continue; // so thin that the rounding of scalars is its gradient
    }
    const TetMesh mesh = linearMesh(named.Make());
    const auto known = verticesWithVolume(mesh);
    const auto atVertices = vertexGradients(mesh);
    ASSERT_EQ(atVertices.size(), mesh.Vertices.size());
    for (std::size_t v = 0; v < atVertices.size(); ++v)
    {
      EXPECT_LT(difference(atVertices[v], known[v] ? Slope : Gradient{}), 2e-5) << v;
    }
    const auto inTets = cellGradients(mesh);
    ASSERT_EQ(inTets.size(), mesh.Tets.size());
    for (Id t = 0; t < mesh.numberOfTets(); ++t)
    {
      const bool flat = volumeSign(mesh, t) == 0;
      EXPECT_LT(difference(inTets[t], flat ? Gradient{} : Slope), 1e-3) << t;
    }
  }
}

// At vertices whose neighbours all lie inside, of which the fit therefore knows the values.
TEST(Gradients, OfLinearFieldsOnCellsAreExactInside)
{
  for (const double jitter : { 0.0, 0.15 })
  {
    const TetMesh mesh = built(jitteredLattice(6, jitter));
    std::vector<float> scalars;
    for (const auto& tet : mesh.Tets)
    {
      double p[3] = { 0, 0, 0 };
      for (const Id v : tet)
      {
        p[0] += 0.25 * double(mesh.Vertices[v].X);
        p[1] += 0.25 * double(mesh.Vertices[v].Y);
        p[2] += 0.25 * double(mesh.Vertices[v].Z);
      }
      scalars.push_back(linear(p[0], p[1], p[2]));
    }
    const auto gradients = vertexGradients(mesh, scalars);
    int compared = 0;
    for (std::size_t i = 0; i < gradients.size(); ++i)
    {
      const Vertex& v = mesh.Vertices[i];
      if (std::max({ std::abs(v.X), std::abs(v.Y), std::abs(v.Z) }) < 0.3f)
      {
        EXPECT_LT(difference(gradients[i], Slope), 1e-5) << i;
        ++compared;
      }
    }
    EXPECT_EQ(compared, 27);
  }
}

TEST(Gradients, OfCellsThatAreAllEqualAreZero)
{
  const TetMesh mesh = built(mixedCells(4, 1, 0.1));
  const std::vector<float> scalars(mesh.Tets.size(), 0.7f);
  for (const Gradient& g : vertexGradients(mesh, scalars))
  {
    EXPECT_LT(difference(g, Gradient{}), 1e-5);
  }
  const TetMesh one = built(singleTet());
  EXPECT_EQ(vertexGradients(one, { 0.4f }), std::vector<Gradient>(4, Gradient{}));
}

TEST(Gradients, WhatIsNotDrawnTakesNoPart)
{
  TetMesh mesh = linearMesh(jitteredLattice(6));
  for (std::size_t v = 0; v < mesh.Vertices.size(); v += 7)
  {
    mesh.Vertices[v].Scalar = UndrawnScalar;
  }
  std::vector<bool> drawn(mesh.Tets.size());
  std::vector<bool> known(mesh.Vertices.size(), false);
  for (Id t = 0; t < mesh.numberOfTets(); ++t)
  {
    const auto& tet = mesh.Tets[t];
    drawn[t] = std::none_of(
      tet.begin(), tet.end(), [&](Id v) { return mesh.Vertices[v].Scalar == UndrawnScalar; });
    for (const Id v : tet)
    {
      known[v] = known[v] || drawn[t];
    }
  }
  EXPECT_GT(std::count(known.begin(), known.end(), false), 50);
  const auto atVertices = vertexGradients(mesh);
  for (std::size_t v = 0; v < known.size(); ++v)
  {
    EXPECT_LT(difference(atVertices[v], known[v] ? Slope : Gradient{}), 1e-5) << v;
  }
  const auto inTets = cellGradients(mesh);
  for (std::size_t t = 0; t < drawn.size(); ++t)
  {
    EXPECT_LT(difference(inTets[t], drawn[t] ? Slope : Gradient{}), 1e-5) << t;
  }
}

TEST(Gradients, CellsThatAreNotDrawnTakeNoPart)
{
  const TetMesh mesh = built(jitteredLattice(6));
  std::vector<float> scalars(mesh.Tets.size(), UndrawnScalar);
  for (const Gradient& g : vertexGradients(mesh, scalars))
  {
    EXPECT_EQ(g, Gradient{});
  }
  for (std::size_t t = 0; t < scalars.size(); t += 2)
  {
    scalars[t] = 0.25f;
  }
  for (const Gradient& g : vertexGradients(mesh, scalars))
  {
    EXPECT_LT(difference(g, Gradient{}), 1e-5);
  }
}

// Random scalars on meshes that are as bad as they come.
TEST(Gradients, AreAlwaysFinite)
{
  std::vector<NamedGrid> grids = everyGrid();
  grids.push_back({ "flat tets", [] { return flatTetsOnBoundary(4); } });
  grids.push_back({ "edges without length", [] { return edgesWithoutLength(4); } });
  grids.push_back({ "paper-thin", [] { return squashedLayers(4, 1e-9); } });
  grids.push_back({ "tangled", [] { return jitteredLattice(5, 1.5); } });
  grids.push_back({ "needles", [] { return needleFan(1000, 1e-4); } });
  grids.push_back({ "nothing", [] { return emptyGrid(); } });
  for (const NamedGrid& named : grids)
  {
    SCOPED_TRACE(named.Name);
    std::mt19937 random(5);
    TetMesh mesh = built(named.Make());
    for (Vertex& v : mesh.Vertices)
    {
      v.Scalar = static_cast<float>(uniform(random));
    }
    std::vector<float> scalars(mesh.Tets.size());
    for (float& scalar : scalars)
    {
      scalar = static_cast<float>(uniform(random));
    }
    for (const auto& gradients :
      { vertexGradients(mesh), vertexGradients(mesh, scalars), cellGradients(mesh) })
    {
      for (const Gradient& g : gradients)
      {
        EXPECT_TRUE(std::isfinite(g[0]) && std::isfinite(g[1]) && std::isfinite(g[2]));
      }
    }
  }
}

TEST(Gradients, AreTheSameHoweverManyThreads)
{
  const TetMesh mesh = linearMesh(mixedCells(8, 1, 0.1));
  std::vector<float> scalars;
  for (const Id cell : mesh.TetCells)
  {
    scalars.push_back(static_cast<float>(cell % 17) / 16.0f);
  }
  const std::string before = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  const auto withThreads = [&](int count)
  {
    vtkSMPTools::Initialize(count);
    return std::vector<std::vector<Gradient>>{ vertexGradients(mesh),
      vertexGradients(mesh, scalars), cellGradients(mesh) };
  };
  EXPECT_EQ(withThreads(1), withThreads(2));
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(before.c_str());
}

TEST(VertexTets, EachIsListedAtItsFourVerticesInOrder)
{
  const TetMesh mesh = built(mixedCells(3, 1, 0.1));
  const VertexTets around(mesh);
  EXPECT_EQ(around.Tets.size(), 4 * mesh.Tets.size());
  for (Id v = 0; v < mesh.Vertices.size(); ++v)
  {
    EXPECT_TRUE(std::is_sorted(around.begin(v), around.end(v)));
    EXPECT_EQ(std::adjacent_find(around.begin(v), around.end(v)), around.end(v));
    for (const Id* t = around.begin(v); t != around.end(v); ++t)
    {
      const auto& tet = mesh.Tets[*t];
      EXPECT_NE(std::find(tet.begin(), tet.end(), v), tet.end());
    }
  }
}
} // namespace
