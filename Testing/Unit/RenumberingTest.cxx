// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Vertices and tetrahedra in a new order, positions in the normalised frame.
#include "Mesh/Renumbering.h"
#include "Mesh/Decomposition.h"
#include "Mesh/TetMeshBuilder.h"

#include "UnitMeshes.h"

#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

TetMesh renumbered(vtkUnstructuredGrid* grid, std::string& error)
{
  TetMesh mesh;
  Decomposition tets;
  bool stopped = false;
  EXPECT_EQ(decompose(grid, {}, tets, stopped), "");
  error = renumber(grid->GetPoints(), std::move(tets), {}, mesh, stopped);
  EXPECT_FALSE(stopped);
  return mesh;
}

TetMesh renumbered(vtkUnstructuredGrid* grid)
{
  std::string error;
  TetMesh mesh = renumbered(grid, error);
  EXPECT_EQ(error, "");
  return mesh;
}

// Mean distance in memory of the vertices of a tetrahedron.
template <typename Tets>
double meanSpan(const Tets& tets)
{
  double sum = 0.0;
  for (const auto& tet : tets)
  {
    const auto ends = std::minmax_element(tet.begin(), tet.end());
    sum += *ends.second - *ends.first;
  }
  return sum / static_cast<double>(tets.size());
}

TEST(Renumbering, IsAPermutationThatKeepsEveryTetrahedron)
{
  for (const Grid& grid : { shuffled(jitteredLattice(5)), jitteredLattice(5), shuffled(lShape(4)) })
  {
    const TetMesh mesh = renumbered(grid);
    std::set<Id> points(mesh.VertexPoints.begin(), mesh.VertexPoints.end());
    EXPECT_EQ(points.size(), mesh.Vertices.size());
    EXPECT_EQ(vtkIdType(mesh.Vertices.size()), grid->GetNumberOfPoints());
    EXPECT_EQ(*points.rbegin(), mesh.Vertices.size() - 1);

    ASSERT_EQ(vtkIdType(mesh.Tets.size()), grid->GetNumberOfCells());
    std::set<Id> cells(mesh.TetCells.begin(), mesh.TetCells.end());
    EXPECT_EQ(cells.size(), mesh.Tets.size());
    for (std::size_t t = 0; t < mesh.Tets.size(); ++t)
    {
      std::set<vtkIdType> ours, theirs;
      vtkIdType count;
      const vtkIdType* ids;
      grid->GetCells()->GetCellAtId(mesh.TetCells[t], count, ids);
      theirs.insert(ids, ids + count);
      for (const Id v : mesh.Tets[t])
      {
        ours.insert(mesh.VertexPoints[v]);
      }
      ASSERT_EQ(ours, theirs);
    }
  }
}

TEST(Renumbering, TetsAreSorted)
{
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    const TetMesh mesh = renumbered(named.Make());
    for (std::size_t t = 0; t < mesh.Tets.size(); ++t)
    {
      const auto& tet = mesh.Tets[t];
      ASSERT_TRUE(tet[0] < tet[1] && tet[1] < tet[2] && tet[2] < tet[3]);
      ASSERT_TRUE(t == 0 || mesh.Tets[t - 1][0] <= tet[0]);
      ASSERT_LT(tet[3], mesh.Vertices.size());
    }
  }
}

TEST(Renumbering, PositionsAreRoundedOnlyOnce)
{
  const Vec3 offset{ 1e6, -2e6, 5e5 };
  for (const double scale : { 1.0, 1e-3, 1e-12, 1e12 })
  {
    const Grid grid = withOffsetAndScale(jitteredLattice(5), scale < 1e-6 ? Vec3{} : offset, scale);
    const TetMesh mesh = renumbered(grid);
    double largest = 0.0;
    for (std::size_t v = 0; v < mesh.Vertices.size(); ++v)
    {
      double p[3];
      grid->GetPoint(mesh.VertexPoints[v], p);
      const float q[3] = { mesh.Vertices[v].X, mesh.Vertices[v].Y, mesh.Vertices[v].Z };
      for (int k = 0; k < 3; ++k)
      {
        // Half an ulp of numbers up to 1, and double's own rounding at the offset.
        const double bound =
          std::ldexp(mesh.Frame.Radius, -25) +
          4 * std::numeric_limits<double>::epsilon() * (std::abs(p[k]) + mesh.Frame.Radius);
        ASSERT_NEAR(mesh.Frame.Center[k] + mesh.Frame.Radius * double(q[k]), p[k], bound);
        largest = std::max(largest, std::abs(double(q[k])));
      }
    }
    EXPECT_NEAR(largest, std::sqrt(1.0 / 3.0), 1e-6);
  }
}

TEST(Renumbering, FrameIsThatOfTheBoundingBox)
{
  const TetMesh cube =
    renumbered(withOffsetAndScale(jitteredLattice(3), { 10.0, 20.0, 30.0 }, 2.0));
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_DOUBLE_EQ(cube.Frame.Center[k], 10.0 * (k + 1) + 1.0);
    EXPECT_DOUBLE_EQ(cube.Frame.HalfExtent[k], std::sqrt(1.0 / 3.0));
  }
  EXPECT_DOUBLE_EQ(cube.Frame.Radius, std::sqrt(3.0));

  const TetMesh tet = renumbered(singleTet());
  EXPECT_EQ(tet.Tets.size(), 1u);
  EXPECT_EQ(tet.Vertices.size(), 4u);
  EXPECT_DOUBLE_EQ(tet.Frame.Radius, std::sqrt(0.75));
  EXPECT_DOUBLE_EQ(tet.Frame.Center[2], 0.5);
}

TEST(Renumbering, NeighboursInSpaceAreNeighboursInMemory)
{
  const Grid grid = shuffled(jitteredLattice(16));
  const TetMesh mesh = renumbered(grid);
  std::vector<std::array<Id, 4>> before;
  for (const auto& tet : mesh.Tets)
  {
    before.push_back({ { mesh.VertexPoints[tet[0]], mesh.VertexPoints[tet[1]],
      mesh.VertexPoints[tet[2]], mesh.VertexPoints[tet[3]] } });
  }
  // Four random ones of n lie 3/5 n apart; on the curve a cube is mostly within a block.
  EXPECT_NEAR(
    meanSpan(before), 0.6 * static_cast<double>(mesh.Vertices.size()), 0.05 * meanSpan(before));
  EXPECT_LT(meanSpan(mesh.Tets), 0.25 * meanSpan(before));
}

TEST(Renumbering, PointsOfNoTetrahedronAreLeftOut)
{
  const Grid grid = singleTet();
  grid->GetPoints()->InsertNextPoint(1e9, std::nan(""), 0.0);
  const TetMesh mesh = renumbered(grid);
  EXPECT_EQ(mesh.Vertices.size(), 4u);
  EXPECT_DOUBLE_EQ(mesh.Frame.Radius, std::sqrt(0.75));
}

TEST(Renumbering, ExtentsFromTinyToHuge)
{
  for (const double scale : { 1e-99, 1e-30, 1e30, 1e99 })
  {
    const TetMesh mesh = built(withOffsetAndScale(singleTet(), {}, scale));
    EXPECT_NEAR(mesh.Frame.Radius / scale, std::sqrt(0.75), 1e-12);
  }
  for (const double scale : { 1e-101, 1e-160, 1e-200, 1e-308 })
  {
    std::string error;
    renumbered(withOffsetAndScale(singleTet(), {}, scale), error);
    EXPECT_NE(error.find("less than 1e-100"), std::string::npos) << scale << error;
  }
}

TEST(Renumbering, AllPointsInOnePlace)
{
  const TetMesh mesh = builtApart(withOffsetAndScale(singleTet(), { 3.0, 4.0, 5.0 }, 0.0));
  EXPECT_EQ(mesh.Frame.Radius, 1.0);
  EXPECT_EQ(mesh.Vertices[3].X, 0.0f);
}
} // namespace
