// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Points with equal coordinates are one vertex: a mesh whose cells have points of their own is the
// same as with shared ones.
#include "Mesh/CoincidentPoints.h"

#include "Mesh/MeshScalars.h"
#include "Mesh/TetMeshBuilder.h"
#include "UnitMeshes.h"

#include "vtkCellType.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

const double NotANumber = std::numeric_limits<double>::quiet_NaN();

// Two tetrahedra with points of their own, the second one's mirrored but for its first point, and
// three points that no tetrahedron has.
Grid twoApart(const Vec3& secondFirst)
{
  GridBuilder builder;
  for (const Vec3& p : std::vector<Vec3>{ { 0.0, 0.1, 0.2 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
         secondFirst, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 }, { 1, 0, 0 }, { NotANumber, 0, 0 },
         { NotANumber, 0, 0 } })
  {
    builder.addPoint(p);
  }
  builder.addCell(VTK_TETRA, { 0, 1, 2, 3 });
  builder.addCell(VTK_TETRA, { 4, 5, 6, 7 });
  builder.addCell(VTK_VERTEX, { 8 });
  return builder.finish(linearField());
}

TEST(CoincidentPoints, AreEqualInEachCoordinate)
{
  const auto first = [](const Vec3& point, bool inFloat)
  {
    const std::vector<Id> firsts = findCoincidentPoints(twoApart(point), inFloat);
    EXPECT_TRUE(firsts.empty() || firsts[8] == NoPoint);
    return firsts.empty() ? 4u : firsts[4];
  };
  const double near = std::nextafter(0.1, 1.0);
  EXPECT_EQ(first({ 0.0, 0.1, 0.2 }, false), 0u);
  EXPECT_EQ(first({ -0.0, 0.1, 0.2 }, false), 0u);
  EXPECT_EQ(first({ 0.0, near, 0.2 }, false), 4u);
  EXPECT_EQ(first({ 0.0, near, 0.2 }, true), 0u);
  EXPECT_EQ(first({ 0.2, 0.1, 0.0 }, false), 4u);
}

template <typename T>
bool areSame(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

// With scalars. Diagonals do not depend on the ids of points.
TetMesh meshOf(vtkUnstructuredGrid* grid)
{
  PieceOptions options;
  options.ByCoordinates = true;
  TetMesh mesh;
  std::string error;
  EXPECT_EQ(buildTetMesh(grid, {}, mesh, error, options), BuildStatus::Done) << error;
  const DrawnScalars drawn{ grid->GetPointData()->GetScalars() };
  const MeshScalars scalars = readScalars(grid, drawn, mesh);
  EXPECT_FALSE(scalars.Jump);
  EXPECT_TRUE(scalars.OfCorners.empty());
  return mesh;
}

TEST(CoincidentPoints, MakeTheMeshOfSharedPoints)
{
  for (const Grid& grid : { jitteredLattice(5, 0.15, 1, sineField()), hexLattice(4, 0.2),
         wedgeLattice(4, 0.1), pyramidLattice(3, 0.1), polyhedronLattice(4, 0.1),
         hexagonalPrismLattice(3), mixedCells(4, 1, 0.1), latticeWithHole(6) })
  {
    const Grid repeated = withRepeatedPoints(grid);
    SCOPED_TRACE(std::to_string(grid->GetCellType(0)));
    ASSERT_GT(repeated->GetNumberOfPoints(), 2 * grid->GetNumberOfPoints());
    const TetMesh expected = meshOf(grid);
    const TetMesh mesh = meshOf(repeated);
    EXPECT_TRUE(mesh.Tets == expected.Tets);
    EXPECT_TRUE(mesh.TetCells == expected.TetCells);
    EXPECT_TRUE(mesh.Links == expected.Links);
    EXPECT_TRUE(areSame(mesh.BoundaryFaces, expected.BoundaryFaces));
    EXPECT_TRUE(areSame(mesh.Hierarchy, expected.Hierarchy));
    EXPECT_TRUE(areSame(mesh.Vertices, expected.Vertices));
    EXPECT_EQ(describe(mesh.Report), describe(expected.Report));
    EXPECT_TRUE(expected.FirstPoints.empty());
  }
}

// By ids, neighbours agree on diagonals as well.
TEST(CoincidentPoints, AreOneForDiagonals)
{
  for (const Grid& grid : { hexLattice(4, 0.2), wedgeLattice(4, 0.1), mixedCells(4, 1, 0.1) })
  {
    const TetMesh mesh = built(withRepeatedPoints(grid));
    EXPECT_EQ(mesh.BoundaryFaces.size(), built(grid).BoundaryFaces.size());
    EXPECT_NEAR(totalVolume(mesh), totalVolume(built(grid)), 1e-6);
    EXPECT_EQ(describe(mesh.Report), "");
  }
}

// A cell without thickness between two others, as of cracks that have not opened.
TEST(CoincidentPoints, OfACellLeaveItOut)
{
  GridBuilder builder;
  for (const Vec3& p : std::vector<Vec3>{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0 },
         { 1, 0, 0 }, { 0, 1, 0 }, { 0.2, 0.2, -1 }, { 0.2, 0.2, 1 } })
  {
    builder.addPoint(p);
  }
  builder.addCell(VTK_TETRA, { 0, 1, 2, 6 });
  builder.addCell(VTK_WEDGE, { 0, 1, 2, 3, 4, 5 });
  builder.addCell(VTK_TETRA, { 3, 4, 5, 7 });
  const TetMesh mesh = built(builder.finish(linearField()));
  EXPECT_EQ(mesh.numberOfTets(), 2u);
  EXPECT_EQ(mesh.BoundaryFaces.size(), 6u);
}

TEST(CoincidentPoints, StaySeparateIfAsked)
{
  const Grid grid = withRepeatedPoints(jitteredLattice(3));
  const TetMesh mesh = builtApart(grid);
  EXPECT_EQ(mesh.Vertices.size(), 4u * mesh.numberOfTets());
  EXPECT_EQ(mesh.BoundaryFaces.size(), 4u * mesh.numberOfTets());
  EXPECT_EQ(mesh.FirstPoints, built(grid).FirstPoints);
}
} // namespace
