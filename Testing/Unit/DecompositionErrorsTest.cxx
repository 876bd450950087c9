// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Oddities of a grid that are no errors, and builds that are stopped.
#include "Mesh/Decomposition.h"
#include "Mesh/TetMeshBuilder.h"

#include "UnitMeshes.h"

#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// A grid of five points and the given cells.
Grid gridOf(const std::vector<std::pair<int, Ids>>& cells)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  points->InsertNextPoint(0.0, 0.0, 1.0);
  points->InsertNextPoint(1.0, 1.0, 1.0);
  grid->SetPoints(points);
  grid->Allocate(static_cast<vtkIdType>(cells.size()));
  for (const auto& cell : cells)
  {
    grid->InsertNextCell(
      cell.first, static_cast<vtkIdType>(cell.second.size()), cell.second.data());
  }
  return grid;
}

TEST(DecompositionErrors, RepeatedPointsAreDroppedAndCounted)
{
  const TetMesh mesh =
    built(gridOf({ { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 1, 2, 4 } } }));
  EXPECT_EQ(mesh.Tets.size(), 1u);
  EXPECT_EQ(mesh.Report.DegenerateTetrahedra, 1);
}

TEST(DecompositionErrors, TypesWithoutATableGoByVTK)
{
  const TetMesh mesh = built(gridOf({ { VTK_TETRA, { 0, 1, 2, 3 } },
    { VTK_CONVEX_POINT_SET, { 0, 1, 2, 3, 4 } }, { VTK_EMPTY_CELL, {} } }));
  // The tetrahedron is part of the hull of all five points, so it comes twice.
  EXPECT_EQ(mesh.Tets.size(), 2u);
  EXPECT_EQ(mesh.Report.DuplicateTetrahedra, 1);
  EXPECT_EQ(mesh.Report.UnsupportedCells, 0);
}

// A convex point set is the hull of its own points, wherever they are among those of the grid.
TEST(DecompositionErrors, ConvexPointSetsAreOfTheirOwnPoints)
{
  GridBuilder builder;
  for (const Vec3& p : std::vector<Vec3>{ { 9, 9, 9 }, { 8, 9, 9 }, { 0, 0, 1 }, { 1, 0, 0 },
         { 0, 1, 0 }, { 9, 8, 9 }, { 0, 0, 0 } })
  {
    builder.addPoint(p);
  }
  builder.addCell(VTK_CONVEX_POINT_SET, { 6, 3, 4, 2 });
  const TetMesh mesh = built(builder.finish(linearField()));
  ASSERT_EQ(mesh.Tets.size(), 1u);
  EXPECT_NEAR(totalVolume(mesh), 1.0 / 6.0, 1e-6);
}

// The middle of such a mesh isn't a number, and the frame must be as large as the larger half.
TEST(DecompositionErrors, MeshesAFewRoundingsWideStayInTheirFrame)
{
  const double eps = std::ldexp(1.0, -52);
  for (const int width : { 1, 2, 3 })
  {
    const Grid grid = singleTet();
    for (vtkIdType i = 0; i < 4; ++i)
    {
      double p[3];
      grid->GetPoint(i, p);
      grid->GetPoints()->SetPoint(
        i, 1 + width * eps * p[0], 1 + width * eps * p[1], 1 + width * eps * p[2]);
    }
    const TetMesh mesh = built(grid);
    for (const Vertex& v : mesh.Vertices)
    {
      EXPECT_LE(std::hypot(double(v.X), double(v.Y), double(v.Z)), 1.0 + 1e-6) << width;
      EXPECT_LE(std::abs(double(v.X)), mesh.Frame.HalfExtent[0] + 1e-6) << width;
    }
  }
}

TEST(DecompositionErrors, StopsWhenAsked)
{
  const Grid grid = jitteredLattice(12);
  for (int calls = 1;; ++calls)
  {
    int left = calls;
    double before = 0.0;
    const Progress progress = [&](double share)
    {
      EXPECT_GE(share, before);
      EXPECT_LE(share, 1.0);
      before = share;
      return --left > 0;
    };
    TetMesh mesh;
    std::string error;
    const BuildStatus status = buildTetMesh(grid, progress, mesh, error);
    EXPECT_EQ(error, "");
    if (left > 0)
    {
      EXPECT_EQ(status, BuildStatus::Done);
      EXPECT_EQ(before, 1.0);
      EXPECT_GT(calls, 4) << "progress in every stage";
      break;
    }
    ASSERT_EQ(status, BuildStatus::Stopped);
    ASSERT_EQ(left, 0) << "asked again after it said stop";
  }
}
} // namespace
