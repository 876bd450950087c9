// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedron at each vertex from which rays start, oriented as the boundary is.
#include "Mesh/VertexStarts.h"
#include "Mesh/Orientation.h"
#include "Mesh/OutsideSigns.h"

#include "UnitMeshes.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;
using Face = std::array<Id, 3>;

std::vector<NamedGrid> gridsWithStarts()
{
  std::vector<NamedGrid> grids = everyGrid();
  grids.push_back({ "tangled", [] { return jitteredLattice(5, 0.6); } });
  grids.push_back({ "more tangled", [] { return shuffled(jitteredLattice(5, 1.5)); } });
  grids.push_back({ "flat inside", [] { return flatTetsInside(8); } });
  grids.push_back({ "flat on the boundary", [] { return flatTetsOnBoundary(8); } });
  grids.push_back({ "edges without length", [] { return edgesWithoutLength(4); } });
  grids.push_back({ "Moebius", [] { return moebiusRing(9); } });
  grids.push_back({ "all flat", []
    {
      return mapped(jitteredLattice(3),
        [](const Vec3& p, vtkIdType) {
          return Vec3{ p[0], p[1], 0.0 };
        });
    } });
  return grids;
}

// The face with its lowest point first, in the same cyclic order.
Face rotated(Face face)
{
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

// Face i of a tetrahedron by the sign of it, as the boundary faces are made.
Face outward(const TetMesh& mesh, Id halfFace, int sign)
{
  const auto face = outwardFace(mesh, halfFace, sign);
  return rotated({ { face[0], face[1], face[2] } });
}

TEST(OutsideSigns, AreThoseOfTheBoundaryAndOfAllLinks)
{
  for (const NamedGrid& named : gridsWithStarts())
  {
    SCOPED_TRACE(named.Name);
    const TetMesh mesh = built(named.Make());
    const auto signs = outsideSigns(mesh);
    ASSERT_EQ(signs.size(), mesh.Tets.size());
    for (Id h = 0; h < 4 * mesh.numberOfTets(); ++h)
    {
      const Id link = mesh.Links[h];
      Face behind;
      if (link >= LinkOutside)
      {
        const auto& face = mesh.BoundaryFaces[link - LinkOutside];
        behind = rotated({ { face[0], face[1], face[2] } });
      }
      else
      {
        const Face other = outward(mesh, link, signs[link / 4]);
        behind = rotated({ { other[0], other[2], other[1] } });
      }
      ASSERT_EQ(outward(mesh, h, signs[h / 4]), behind) << h;
    }
  }
}

TEST(VertexStarts, TurnTheirFacesOutwards)
{
  for (const NamedGrid& named : gridsWithStarts())
  {
    SCOPED_TRACE(named.Name);
    const TetMesh mesh = built(named.Make());
    const auto signs = outsideSigns(mesh);
    const auto starts = vertexStarts(mesh);
    ASSERT_EQ(starts.size(), mesh.Vertices.size());
    for (Id v = 0; v < starts.size(); ++v)
    {
      const Id t = starts[v][3];
      if (t == NoTet)
      {
        for (const auto& tet : mesh.Tets)
        {
          ASSERT_EQ(std::count(tet.begin(), tet.end(), v), 0) << v;
        }
        continue;
      }
      ASSERT_LT(t, mesh.numberOfTets());
      const Id a = v, b = starts[v][0], c = starts[v][1], d = fourthVertex(mesh, v, starts[v]);
      ASSERT_EQ(starts[v][2], mesh.Links[4 * t + 3]) << v;
      std::array<Id, 4> members{ { a, b, c, d } };
      std::sort(members.begin(), members.end());
      ASSERT_EQ(members, mesh.Tets[t]) << v;
      const auto opposite = [&](Id vertex)
      {
        const auto& tet = mesh.Tets[t];
        return 4 * t + static_cast<Id>(std::find(tet.begin(), tet.end(), vertex) - tet.begin());
      };
      EXPECT_EQ(rotated({ { a, b, c } }), outward(mesh, opposite(d), signs[t])) << v;
      EXPECT_EQ(rotated({ { a, d, b } }), outward(mesh, opposite(c), signs[t])) << v;
      EXPECT_EQ(rotated({ { b, d, c } }), outward(mesh, opposite(a), signs[t])) << v;
      EXPECT_EQ(rotated({ { c, d, a } }), outward(mesh, opposite(b), signs[t])) << v;
    }
  }
}

// In a sound mesh that is what coordinates say.
TEST(VertexStarts, LieBehindTheirFacesInSoundMeshes)
{
  for (const Grid& grid : { shuffled(jitteredLattice(5)), mixedCells(4, 1, 0.0) })
  {
    const TetMesh mesh = built(grid);
    const auto starts = vertexStarts(mesh);
    for (Id v = 0; v < starts.size(); ++v)
    {
      const Id last = fourthVertex(mesh, v, starts[v]);
      EXPECT_LT(sixVolumes(mesh, { { v, starts[v][0], starts[v][1], last } }), 0.0) << v;
    }
  }
}

// By the heights of the tetrahedron: 1/r is the sum of 1/h.
double inscribedRadius(const TetMesh& mesh, Id t)
{
  const double six = std::abs(sixVolumes(mesh, mesh.Tets[t]));
  double sum = 0;
  for (int i = 0; i < 4; ++i)
  {
    const Vertex& o = mesh.Vertices[mesh.Tets[t][(i + 1) % 4]];
    const Vertex& p = mesh.Vertices[mesh.Tets[t][(i + 2) % 4]];
    const Vertex& q = mesh.Vertices[mesh.Tets[t][(i + 3) % 4]];
    const double a[3] = { double(p.X) - double(o.X), double(p.Y) - double(o.Y),
      double(p.Z) - double(o.Z) };
    const double b[3] = { double(q.X) - double(o.X), double(q.Y) - double(o.Y),
      double(q.Z) - double(o.Z) };
    const double area =
      std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    const double height = area > 0 ? six / area : 0;
    sum += height > 0 ? 1 / height : std::numeric_limits<double>::infinity();
  }
  return 1 / sum;
}

TEST(VertexStarts, AreTheRoomiestAndOfEqualsTheFirst)
{
  for (const NamedGrid& named : gridsWithStarts())
  {
    SCOPED_TRACE(named.Name);
    const TetMesh mesh = built(named.Make());
    const auto starts = vertexStarts(mesh);
    for (Id t = 0; t < mesh.numberOfTets(); ++t)
    {
      const double radius = inscribedRadius(mesh, t);
      for (const Id v : mesh.Tets[t])
      {
        const Id chosen = starts[v][3];
        const double its = inscribedRadius(mesh, chosen);
        EXPECT_LE(radius, its * (1 + 1e-12)) << v;
        EXPECT_TRUE(chosen <= t || its > radius * (1 - 1e-12)) << v;
        EXPECT_TRUE(chosen <= t || radius != 0 || its != 0) << v;
      }
    }
  }
}

TEST(VertexStarts, OfNoTetAndHoweverManyThreads)
{
  TetMesh mesh = built(jitteredLattice(8, 0.6));
  mesh.Vertices.push_back({ 0, 0, 0, 0 });
  const std::string before = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(1);
  const auto one = vertexStarts(mesh);
  vtkSMPTools::Initialize(2);
  EXPECT_EQ(vertexStarts(mesh), one);
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(before.c_str());
  EXPECT_EQ(one.back(), (std::array<Id, 4>{ { 0, 0, 0, NoTet } }));
  EXPECT_TRUE(vertexStarts(built(emptyGrid())).empty());
}
} // namespace
