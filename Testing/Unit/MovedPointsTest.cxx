// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh whose points were moved is the mesh that is built of the moved grid, but for its numbers.
#include "Mesh/MovedPoints.h"

#include "Mesh/MeshStage.h"
#include "Mesh/TetMeshBuilder.h"
#include "UnitMeshes.h"

#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <set>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// The mesh bent by a fraction of its size; beyond 1 it folds.
Grid bent(vtkUnstructuredGrid* grid, double amount)
{
  auto result = Grid::New();
  result->DeepCopy(grid);
  double box[6];
  grid->GetBounds(box);
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    double p[3];
    result->GetPoint(i, p);
    const double x = (p[0] - box[0]) / std::max(box[1] - box[0], 1e-300);
    p[2] += amount * x * x * (box[5] - box[4]);
    p[1] += amount * 0.1 * std::sin(6.0 * x) * (box[3] - box[2]);
    result->GetPoints()->SetPoint(i, p);
  }
  return result;
}

TetMesh built(vtkUnstructuredGrid* grid)
{
  TetMesh mesh;
  std::string error;
  EXPECT_EQ(buildTetMesh(grid, {}, mesh, error), BuildStatus::Done) << error;
  return mesh;
}

using Points4 = std::array<Id, 4>;

Points4 pointsOf(const TetMesh& mesh, Id tet)
{
  Points4 points = mesh.Tets[tet];
  for (Id& vertex : points)
  {
    vertex = mesh.VertexPoints[vertex];
  }
  std::sort(points.begin(), points.end());
  return points;
}

// Which tetrahedra lie behind the faces of which, by the points of the grid.
std::multimap<Points4, Points4> neighboursOf(const TetMesh& mesh)
{
  std::multimap<Points4, Points4> neighbours;
  for (Id t = 0; t < mesh.numberOfTets(); ++t)
  {
    std::set<Points4> behind;
    for (Id i = 0; i < 4; ++i)
    {
      const Id link = mesh.Links[4 * std::size_t(t) + i];
      if (link < LinkOutside)
      {
        behind.insert(pointsOf(mesh, link / 4));
        EXPECT_EQ(mesh.Links[link], 4 * t + i);
      }
    }
    for (const Points4& points : behind)
    {
      neighbours.emplace(pointsOf(mesh, t), points);
    }
  }
  return neighbours;
}

// The points of a face in their cyclic order, the smallest first.
std::set<Points4> facesOf(const TetMesh& mesh)
{
  std::set<Points4> faces;
  for (std::size_t b = 0; b < mesh.BoundaryFaces.size(); ++b)
  {
    const auto& face = mesh.BoundaryFaces[b];
    Points4 points{ { mesh.VertexPoints[face[0]], mesh.VertexPoints[face[1]],
      mesh.VertexPoints[face[2]], 0 } };
    std::rotate(
      points.begin(), std::min_element(points.begin(), points.begin() + 3), points.begin() + 3);
    points[3] = mesh.TetCells[face[3] / 4];
    faces.insert(points);
    EXPECT_EQ(mesh.Links[face[3]], LinkOutside + b);
  }
  return faces;
}

std::map<Id, std::array<float, 3>> positionsOf(const TetMesh& mesh)
{
  std::map<Id, std::array<float, 3>> positions;
  for (std::size_t v = 0; v < mesh.Vertices.size(); ++v)
  {
    const Vertex& vertex = mesh.Vertices[v];
    positions[mesh.VertexPoints[v]] = { { vertex.X, vertex.Y, vertex.Z } };
  }
  return positions;
}

void expectSameMesh(const TetMesh& moved, const TetMesh& anew)
{
  EXPECT_EQ(neighboursOf(moved), neighboursOf(anew));
  EXPECT_EQ(facesOf(moved), facesOf(anew));
  EXPECT_EQ(positionsOf(moved), positionsOf(anew));
  EXPECT_EQ(moved.Frame.Center, anew.Frame.Center);
  EXPECT_EQ(moved.Frame.Radius, anew.Frame.Radius);
  EXPECT_EQ(moved.Frame.HalfExtent, anew.Frame.HalfExtent);
  EXPECT_EQ(moved.MayReenter, anew.MayReenter);
  EXPECT_EQ(moved.Hierarchy.empty(), anew.Hierarchy.empty());
  EXPECT_EQ(moved.ReentryFaces, anew.ReentryFaces);
  EXPECT_EQ(describe(moved.Report), describe(anew.Report));
}

TEST(MovedPoints, AreThoseOfAMeshThatIsBuilt)
{
  int moved = 0;
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    const Grid grid = named.Make();
    for (const double amount : { 0.0, 0.02, 0.4, 3.0 })
    {
      const Grid other = bent(grid, amount);
      TetMesh mesh = built(grid);
      if (movePoints(other, mesh))
      {
        expectSameMesh(mesh, built(other));
        ++moved;
      }
    }
  }
  std::cout << "[ MEASURED ] " << moved << " of " << 4 * everyGrid().size() << " were moved\n";
  EXPECT_GT(moved, 20);
}

TEST(MovedPoints, AtRandom)
{
  const Grid first = jitteredLattice(5, 0.15, 1);
  TetMesh mesh = built(first);
  for (unsigned seed = 2; seed < 12; ++seed)
  {
    const Grid next = jitteredLattice(5, 0.15, seed);
    ASSERT_TRUE(movePoints(next, mesh));
    expectSameMesh(mesh, built(next));
  }
}

TEST(MovedPoints, FromConvexToConcaveAndBack)
{
  const Grid cube = jitteredLattice(4, 0.0);
  TetMesh mesh = built(cube);
  EXPECT_FALSE(mesh.MayReenter);
  for (int i = 0; i < 2; ++i)
  {
    ASSERT_TRUE(movePoints(bent(cube, 0.3), mesh));
    EXPECT_TRUE(mesh.MayReenter);
    ensureHierarchy(mesh);
    ASSERT_TRUE(movePoints(cube, mesh));
    EXPECT_FALSE(mesh.MayReenter);
    EXPECT_TRUE(mesh.Hierarchy.empty());
    expectSameMesh(mesh, built(cube));
  }
}

TEST(MovedPoints, MirroredMeshesStayThemselves)
{
  const Grid grid = jitteredLattice(4);
  const Grid mirrored = bent(grid, 0.0);
  for (vtkIdType i = 0; i < mirrored->GetNumberOfPoints(); ++i)
  {
    mirrored->GetPoints()->GetData()->SetComponent(i, 0, -mirrored->GetPoint(i)[0]);
  }
  TetMesh mesh = built(grid);
  ASSERT_TRUE(movePoints(mirrored, mesh));
  expectSameMesh(mesh, built(mirrored));
}

TEST(MovedPoints, WhatDoesNotFollowFromCellsIsBuilt)
{
  TetMesh cut = built(mixedCells(3));
  EXPECT_FALSE(movePoints(mixedCells(3), cut));
  const Grid grid = jitteredLattice(4);
  const auto isMoved = [&grid](vtkIdType point, double x)
  {
    const Grid other = bent(grid, 0.0);
    other->GetPoints()->GetData()->SetComponent(point, 0, x);
    TetMesh mesh = built(grid);
    return movePoints(other, mesh);
  };
  EXPECT_TRUE(isMoved(62, 0.51));
  EXPECT_FALSE(isMoved(62, 0.9)); // beyond its neighbours
  EXPECT_FALSE(isMoved(62, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(isMoved(62, 1e101));
  const Grid more = bent(grid, 0.0);
  more->GetPoints()->InsertNextPoint(0.0, 0.0, 0.0);
  TetMesh mesh = built(grid);
  EXPECT_FALSE(movePoints(more, mesh));
}

TEST(MovedPoints, CoincideAsBefore)
{
  const Grid grid = withRepeatedPoints(jitteredLattice(4));
  TetMesh mesh = built(grid);
  const Grid next = bent(grid, 0.2);
  ASSERT_TRUE(movePoints(next, mesh));
  expectSameMesh(mesh, built(next));
  // A crack opens, and closes again.
  const Grid cracked = bent(grid, 0.0);
  cracked->GetPoints()->GetData()->SetComponent(1, 0, 1e-6);
  EXPECT_FALSE(movePoints(cracked, mesh));
  mesh = built(cracked);
  EXPECT_FALSE(movePoints(grid, mesh));
}

TEST(MovedPoints, InAStage)
{
  const Grid grid = jitteredLattice(4);
  MeshStage stage;
  ASSERT_EQ(stage.make(grid, {}, {}), "");
  const auto numbers = stage.mesh().VertexPoints;
  const Grid next = jitteredLattice(4, 0.15, 7);
  EXPECT_FALSE(stage.isCurrent(next));
  ASSERT_EQ(stage.make(next, {}, {}), "");
  EXPECT_TRUE(stage.mesh().VertexPoints == numbers);
  expectSameMesh(stage.mesh(), built(next));
  EXPECT_TRUE(stage.isCurrent(next));
  EXPECT_FALSE(stage.isCurrent(grid));
  // A tetrahedron that turns over: as if nothing had been there before.
  const Grid turned = bent(next, 0.0);
  turned->GetPoints()->GetData()->SetComponent(62, 0, 0.9);
  ASSERT_EQ(stage.make(turned, {}, {}), "");
  EXPECT_EQ(stage.mesh().VertexPoints, built(turned).VertexPoints);
  EXPECT_GT(stage.mesh().Report.FoldedFaces, 0);
  EXPECT_EQ(stage.record().Runs, 3);
}
} // namespace
