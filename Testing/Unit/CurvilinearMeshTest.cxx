// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The computed cells of a curvilinear grid are those of its hexahedra, with their links.
#include "Mesh/CurvilinearMesh.h"
#include "Geometry/Vector3.h"
#include "Mesh/MeshSizes.h"
#include "Mesh/Orientation.h"

#include "CurvilinearGrids.h"
#include "GridTransforms.h"
#include "MarchedMesh.h"
#include "MeshConventions.h"
#include "StoredCells.h"

#include "vtkMath.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

constexpr std::array<int, 3> Sizes[] = { { 1, 1, 1 }, { 2, 3, 4 }, { 7, 1, 2 }, { 1, 5, 1 },
  { 10, 12, 11 } };

TetMesh computed(vtkStructuredGrid* grid)
{
  TetMesh mesh;
  std::string error;
  EXPECT_EQ(buildCurvilinearMesh(grid, {}, true, mesh, error), BuildStatus::Done);
  EXPECT_EQ(error, "");
  return mesh;
}

using Points = std::vector<Id>; // ascending

// Each tetrahedron by its points of the grid, which ascend. The last number is that of its cell or,
// if the cells are tetrahedra of hexahedra, of its hexahedron.
std::set<Points> tetsOf(const TetMesh& mesh, Id tetsOfCell = 1)
{
  std::set<Points> tets;
  for (std::size_t t = 0; t < mesh.Tets.size(); ++t)
  {
    if (mesh.isDegenerate(t))
    {
      continue;
    }
    Points points;
    for (const Id vertex : mesh.Tets[t])
    {
      points.push_back(mesh.VertexPoints[vertex]);
    }
    std::sort(points.begin(), points.end());
    points.push_back(mesh.TetCells[t] / tetsOfCell);
    EXPECT_TRUE(tets.insert(points).second);
  }
  return tets;
}

// From outside counter-clockwise, the lowest point first.
std::set<Points> facesOf(const TetMesh& mesh)
{
  std::set<Points> faces;
  for (const auto& face : mesh.BoundaryFaces)
  {
    Points points;
    for (int i = 0; i < 3; ++i)
    {
      points.push_back(mesh.VertexPoints[face[i]]);
    }
    std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    EXPECT_TRUE(faces.insert(points).second);
  }
  return faces;
}

TEST(CurvilinearMesh, IsThatOfItsHexahedra)
{
  for (const NamedMovement& movement : everyMovement())
  {
    for (const auto& size : Sizes)
    {
      SCOPED_TRACE(std::string(movement.Name) + ", " + std::to_string(size[0]) + " x " +
                   std::to_string(size[1]) + " x " + std::to_string(size[2]));
      const auto grid = curvilinearGrid(size, movement.Move);
      const TetMesh mesh = computed(grid);
      if (!movement.Computed)
      {
        if (size == Sizes[0])
        {
          continue; // a ring of one cell has poles
        }
        EXPECT_TRUE(mesh.Tets.empty());
        EXPECT_FALSE(mesh.Curvilinear);
        continue;
      }
      if (mesh.Tets.empty()) // few cells may be turned too far
      {
        EXPECT_TRUE(movement.Joined || movement.Name == std::string("three quarters of a ring"));
        EXPECT_NE(size, Sizes[4]);
        continue;
      }
      EXPECT_EQ(mesh.Curvilinear->joins().any(), movement.Joined);
      // A stored hexahedron is cut along other diagonals if points of it coincide.
      const TetMesh stored =
        built(movement.Joined ? inTetrahedra(withStoredCells(grid)) : hexahedraOf(grid));
      expectConventions(mesh);
      EXPECT_EQ(tetsOf(mesh), tetsOf(stored, movement.Joined ? 6 : 1));
      EXPECT_EQ(facesOf(mesh), facesOf(stored));
      EXPECT_EQ(mesh.MayReenter, stored.MayReenter);
      TetMesh searched = mesh;
      ensureHierarchy(searched);
      expectConventions(searched);
      expectConventions(mesh); // which shares nothing with it that is changed
    }
  }
}

// Hexahedra at random: cells are computed if none of the six tetrahedra is turned inside out.
TEST(CurvilinearMesh, LooksAtEachTetrahedron)
{
  std::mt19937 random(1);
  const auto moved = [&](double x) { return x + 1.2 * (double(random()) / 4294967296.0 - 0.5); };
  std::array<int, 6> turnedAlone{};
  int computedGrids = 0;
  for (int round = 0; round < 2000; ++round)
  {
    const auto grid = curvilinearGrid({ 1, 1, 1 },
      [&](const Vec3& p) {
        return Vec3{ moved(p[0]), moved(p[1]), moved(p[2]) };
      });
    int positive = 0; // flags of tetrahedra
    for (int tet = 0; tet < 6; ++tet)
    {
      const int a = tet / 2, b = (a + 1 + tet % 2) % 3;
      Vector3 corners[4];
      const int path[4] = { 0, 1 << a, 1 << a | 1 << b, 7 };
      for (int i = 0; i < 4; ++i)
      {
        grid->GetPoint(path[i], corners[i].data());
      }
      const double volume =
        dot(cross(corners[1] - corners[0], corners[2] - corners[0]), corners[3] - corners[0]);
      positive |= (tet % 2 == 0 ? volume : -volume) > 0 ? 1 << tet : 0;
    }
    const bool alike = positive == 0 || positive == 63;
    EXPECT_EQ(computed(grid).Tets.empty(), !alike) << round;
    computedGrids += alike ? 1 : 0;
    for (int tet = 0; tet < 6; ++tet)
    {
      turnedAlone[tet] += positive == (63 & ~(1 << tet)) || positive == 1 << tet ? 1 : 0;
    }
  }
  EXPECT_GT(computedGrids, 50);
  EXPECT_GT(*std::min_element(turnedAlone.begin(), turnedAlone.end()), 5);
}

// The sine of a whole turn, or of half a one, is not exactly 0.
TEST(CurvilinearMesh, JoinsSidesWithinRounding)
{
  const auto onSphere = [](const Vec3& p)
  {
    const double angle = vtkMath::Pi() * p[1], turn = 2 * vtkMath::Pi() * p[0];
    const double radius = 6371.0 * (0.8 + 0.2 * p[2]);
    return Vec3{ radius * std::sin(angle) * std::cos(turn),
      radius * std::sin(angle) * std::sin(turn), radius * std::cos(angle) };
  };
  const auto grid = curvilinearGrid({ 24, 12, 3 }, onSphere);
  Vec3 first, last;
  grid->GetPoint(25 * 6, first.data());
  grid->GetPoint(25 * 6 + 24, last.data());
  EXPECT_NE(first, last);
  const TetMesh mesh = computed(grid);
  ASSERT_TRUE(mesh.Curvilinear);
  const JoinedSides& joins = mesh.Curvilinear->joins();
  EXPECT_EQ(joins.Rings, (std::array<bool, 3>{ { true, false, false } }));
  EXPECT_EQ(joins.Poles, (std::array<Id, 6>{ { 0, 0, 1, 1, 0, 0 } }));
  expectConventions(mesh);
  // Those of the inner and the outer sphere, each with two rings of triangles around the poles.
  EXPECT_EQ(mesh.BoundaryFaces.size(), 2 * 2 * 24 * (12 - 1));
}

// At most 24 bytes a hexahedron on the GPU (16 of its point), cells with scalars included.
TEST(CurvilinearMesh, TakesFewBytes)
{
  for (const bool ofCells : { false, true })
  {
    const TetMesh mesh = computed(curvilinearGrid({ 100, 100, 100 }, everyMovement()[2].Move));
    const std::size_t cells = 100 * 100 * 100;
    const auto sizes = bufferSizes(mesh, ofCells ? cells : 0, cells * 6 / 32);
    const std::uint64_t bytes = std::accumulate(sizes.begin(), sizes.end(), std::uint64_t(0),
      [](std::uint64_t sum, const BufferSize& size)
      { return sum + size.Texels * size.BytesPerTexel; });
    EXPECT_LE(double(bytes) / cells, ofCells ? 28.0 : 24.0);
    std::cout << "[ MEASURED ] bytes of a hexahedron" << (ofCells ? ", scalars of cells: " : ": ")
              << double(bytes) / cells << "\n";
  }
}
} // namespace
