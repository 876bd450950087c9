// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Every half-face knows what lies behind it, and what lies behind knows it.
#include "Mesh/HalfFaceLinks.h"
#include "Mesh/Orientation.h"

#include "Fields.h"
#include "GridSummary.h"
#include "MeshConventions.h"
#include "UnitMeshes.h"

#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <set>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

TEST(HalfFaceLinks, NeighboursPointBack)
{
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    expectConventions(built(named.Make()));
    expectConventions(builtWithHierarchy(named.Make()));
  }
}

TEST(HalfFaceLinks, NoFaceInsideIsBoundary)
{
  const auto expectFaces = [](vtkUnstructuredGrid* grid)
  {
    const GridSummary summary = summarise(grid);
    const TetMesh mesh = built(grid);
    EXPECT_EQ(vtkIdType(mesh.BoundaryFaces.size()), summary.FacesOnBoundary);
    EXPECT_EQ(mesh.Report.NonManifoldFaces, 0);
    EXPECT_EQ(mesh.Report.DuplicateTetrahedra, 0);
  };
  expectFaces(jitteredLattice(6));
  expectFaces(shuffled(jitteredLattice(6)));
  expectFaces(latticeWithHole(6));
  expectFaces(nestedShells(8));
  expectFaces(twoComponents(4));
  EXPECT_EQ(built(mixedCells(6, 1, 0.1)).BoundaryFaces.size(), 2u * 6 * 36);
}

// The same face from three tetrahedra, and the one with the lowest number chooses its partner.
TEST(HalfFaceLinks, FacesOfThreeOwners)
{
  GridBuilder builder;
  for (const Vec3& p : std::vector<Vec3>{
         { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, -1 }, { 0.1, 0.1, 0.5 } })
  {
    builder.addPoint(p);
  }
  builder.addCell(VTK_TETRA, { 0, 1, 2, 3 });
  builder.addCell(VTK_TETRA, { 0, 1, 2, 4 });
  builder.addCell(VTK_TETRA, { 0, 1, 2, 5 });
  const TetMesh mesh = built(builder.finish(linearField()));
  expectConventions(mesh);
  EXPECT_EQ(mesh.Report.NonManifoldFaces, 1);
  EXPECT_EQ(mesh.BoundaryFaces.size(), 10u);
  EXPECT_EQ(mesh.Tets.size(), 3u);

  std::vector<Id> joined;
  for (Id t = 0; t < 3; ++t)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (mesh.Links[4 * t + i] < LinkOutside)
      {
        joined.push_back(4 * t + i);
      }
    }
  }
  ASSERT_EQ(joined.size(), 2u);
  EXPECT_EQ(inwardSide(mesh, joined[0]), -inwardSide(mesh, joined[1]));
  // Tetrahedron 0 is the first owner; it is one of the two on its side or the only one on its own.
  EXPECT_EQ(joined[0] / 4, 0u);
}

TEST(HalfFaceLinks, DefectsAreCountedAndMended)
{
  const TetMesh mesh = built(defectiveTets());
  expectConventions(mesh);
  EXPECT_EQ(mesh.Report.DegenerateTetrahedra, 1);
  EXPECT_EQ(mesh.Report.DuplicateTetrahedra, 1);
  EXPECT_EQ(mesh.Report.NonManifoldFaces, 1);
  EXPECT_EQ(mesh.Tets.size(), 3u);
  // Of the two equal ones the first stays.
  EXPECT_EQ(std::set<Id>(mesh.TetCells.begin(), mesh.TetCells.end()), (std::set<Id>{ 0, 3, 4 }));
  EXPECT_NE(describe(mesh.Report), "");
  EXPECT_EQ(describe(built(mixedDimensions(2)).Report), "");
}

TEST(HalfFaceLinks, ManyDuplicates)
{
  const Grid once = jitteredLattice(4);
  const Grid twice = jitteredLattice(4);
  for (int repeat = 0; repeat < 2; ++repeat)
  {
    for (vtkIdType i = 0; i < once->GetNumberOfCells(); ++i)
    {
      vtkIdType count;
      const vtkIdType* ids;
      once->GetCells()->GetCellAtId(i, count, ids);
      const vtkIdType turned[4] = { ids[3], ids[1], ids[0], ids[2] };
      twice->InsertNextCell(VTK_TETRA, 4, turned);
    }
  }
  const TetMesh a = built(once);
  const TetMesh b = built(twice);
  expectConventions(b);
  EXPECT_EQ(b.Report.DuplicateTetrahedra, 2 * once->GetNumberOfCells());
  EXPECT_EQ(b.Tets, a.Tets);
  EXPECT_EQ(b.BoundaryFaces, a.BoundaryFaces);
  EXPECT_EQ(b.Report.NonManifoldFaces, 0);
}

TEST(HalfFaceLinks, TheSameFromRunToRunAndHoweverManyThreads)
{
  const Grid grid = shuffled(nestedShells(16));
  const TetMesh first = built(grid);
  const std::string before = vtkSMPTools::GetBackend();
  for (const char* backend : { "Sequential", "STDThread", "TBB", "STDThread" })
  {
    if (!vtkSMPTools::SetBackend(backend))
    {
      continue; // not in this VTK
    }
    const TetMesh again = built(grid);
    EXPECT_EQ(again.Tets, first.Tets);
    EXPECT_EQ(again.BoundaryFaces, first.BoundaryFaces);
    EXPECT_EQ(again.TetCells, first.TetCells);
    EXPECT_EQ(again.VertexPoints, first.VertexPoints);
    EXPECT_EQ(again.Links, first.Links);
    ASSERT_EQ(again.Hierarchy.size(), first.Hierarchy.size());
    EXPECT_EQ(std::memcmp(again.Hierarchy.data(), first.Hierarchy.data(),
                first.Hierarchy.size() * sizeof(HierarchyNode)),
      0);
  }
  vtkSMPTools::SetBackend(before.c_str());
}

TEST(HalfFaceLinks, NothingToLink)
{
  const TetMesh mesh = built(triangleAndLineGrid());
  EXPECT_TRUE(mesh.Tets.empty());
  EXPECT_TRUE(mesh.Links.empty());
  EXPECT_TRUE(mesh.BoundaryFaces.empty());
  EXPECT_TRUE(built(emptyGrid()).Tets.empty());
}

// Two cubes side by side as polyhedra; the square between them is two quads that share the point m
// near a diagonal of the square, so that both quads are cut along it and overlap in a triangle.
Grid cubesWithOverlappingQuads(double y, double z)
{
  const auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  for (const double x : { 1.0, 0.0, 2.0 }) // ids 0..3 lie between the cubes, 0 is on the diagonal
  {
    points->InsertNextPoint(x, 0, 0);
    points->InsertNextPoint(x, 1, 0);
    points->InsertNextPoint(x, 1, 1);
    points->InsertNextPoint(x, 0, 1);
  }
  const vtkIdType m = points->InsertNextPoint(1, y, z);
  grid->SetPoints(points);
  for (const vtkIdType o : { 4, 8 })
  {
    const std::vector<vtkIdType> faces = { 4, 1, 2, m, 0, 4, 0, m, 2, 3, 4, o, o + 1, o + 2, o + 3,
      4, 0, 1, o + 1, o, 4, 1, 2, o + 2, o + 1, 4, 2, 3, o + 3, o + 2, 4, 3, 0, o, o + 3 };
    const std::vector<vtkIdType> ids = { 0, 1, 2, 3, m, o, o + 1, o + 2, o + 3 };
    grid->InsertNextCell(
      VTK_POLYHEDRON, static_cast<vtkIdType>(ids.size()), ids.data(), 7, faces.data());
  }
  attachFields(grid, linearField());
  return grid;
}

TEST(HalfFaceLinks, OverlappingQuadsOfCellsCancel)
{
  for (const auto& m : { std::array<double, 2>{ 0.6, 0.5 }, { 0.5, 0.6 }, { 0.5, 0.5 } })
  {
    const TetMesh mesh = built(cubesWithOverlappingQuads(m[0], m[1]));
    expectConventions(mesh);
    EXPECT_EQ(mesh.BoundaryFaces.size(), 20u); // ten squares
    EXPECT_EQ(mesh.Report.NonManifoldFaces, 0);
    EXPECT_EQ(mesh.Report.DuplicateTetrahedra, 0);
  }
}
} // namespace
