// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Boundary faces turn counter-clockwise seen from outside; convex meshes are known as such.
#include "Mesh/Convexity.h"
#include "Mesh/Orientation.h"

#include "UnitMeshes.h"

#include "vtkCellType.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

// Volume inside the boundary by the divergence theorem, in the coordinates of the grid.
double enclosedVolume(const TetMesh& mesh)
{
  double sum = 0.0;
  for (const auto& face : mesh.BoundaryFaces)
  {
    const Vertex& a = mesh.Vertices[face[0]];
    const Vertex& b = mesh.Vertices[face[1]];
    const Vertex& c = mesh.Vertices[face[2]];
    sum += double(a.X) * (double(b.Y) * double(c.Z) - double(b.Z) * double(c.Y)) +
           double(a.Y) * (double(b.Z) * double(c.X) - double(b.X) * double(c.Z)) +
           double(a.Z) * (double(b.X) * double(c.Y) - double(b.Y) * double(c.X));
  }
  return sum / 6.0 * mesh.Frame.Radius * mesh.Frame.Radius * mesh.Frame.Radius;
}

// Of closed surfaces each edge is run through as often in one direction as in the other.
void expectClosed(const TetMesh& mesh)
{
  std::map<std::pair<Id, Id>, int> runs;
  for (const auto& face : mesh.BoundaryFaces)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Id a = face[i], b = face[(i + 1) % 3];
      runs[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
    }
  }
  for (const auto& run : runs)
  {
    ASSERT_EQ(run.second, 0) << run.first.first << " - " << run.first.second;
  }
}

TEST(Orientation, FacesTurnOutwards)
{
  for (const NamedGrid& named : everyGrid())
  {
    SCOPED_TRACE(named.Name);
    const TetMesh mesh = built(named.Make());
    for (std::size_t b = 0; b < mesh.BoundaryFaces.size(); ++b)
    {
      const auto& face = mesh.BoundaryFaces[b];
      const Id apex = mesh.Tets[face[3] / 4][face[3] % 4];
      ASSERT_LE(sixVolumes(mesh, { { face[0], face[1], face[2], apex } }), 0.0);
    }
    if (named.Name != std::string("defectiveTets"))
    {
      expectClosed(mesh);
      // Products of a few doubles about 1, as many as there are faces.
      EXPECT_NEAR(enclosedVolume(mesh) / totalVolume(mesh), 1.0, 1e-10);
    }
  }
}

TEST(Orientation, InvertedTetsMakeNoDifference)
{
  const Grid grid = jitteredLattice(4);
  const Grid turned = jitteredLattice(4);
  for (vtkIdType i = 0; i < turned->GetNumberOfCells(); i += 3)
  {
    vtkIdType count;
    const vtkIdType* ids;
    grid->GetCells()->GetCellAtId(i, count, ids);
    const vtkIdType swapped[4] = { ids[1], ids[0], ids[2], ids[3] };
    turned->GetCells()->ReplaceCellAtId(i, 4, swapped);
  }
  const TetMesh a = built(grid);
  const TetMesh b = built(turned);
  EXPECT_EQ(a.Tets, b.Tets);
  EXPECT_EQ(a.BoundaryFaces, b.BoundaryFaces);
}

// Flat tetrahedra on the boundary take the side of their neighbours.
TEST(Orientation, FlatTetsOnTheBoundary)
{
  GridBuilder builder;
  for (const Vec3& p :
    std::vector<Vec3>{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.3, 0.4, 1 } })
  {
    builder.addPoint(p);
  }
  // A pyramid cut along one diagonal of its base, and a flat one under it with the other.
  builder.addCell(VTK_TETRA, { 0, 1, 2, 4 });
  builder.addCell(VTK_TETRA, { 0, 2, 3, 4 });
  builder.addCell(VTK_TETRA, { 0, 1, 2, 3 });
  const TetMesh mesh = built(builder.finish(linearField()));
  EXPECT_EQ(mesh.BoundaryFaces.size(), 6u);
  expectClosed(mesh);
  EXPECT_NEAR(enclosedVolume(mesh), 1.0 / 3.0, 1e-6);
  int flat = 0;
  for (Id t = 0; t < 3; ++t)
  {
    flat += inwardSide(mesh, 4 * t) == 0;
  }
  EXPECT_EQ(flat, 1);
  EXPECT_TRUE(isConvex(mesh));
}

// Everything is flat: either side of a face is as good, and nothing hangs or fails.
TEST(Orientation, AFlatMeshIsNoProblem)
{
  const Grid grid = jitteredLattice(3);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double p[3];
    grid->GetPoint(i, p);
    grid->GetPoints()->SetPoint(i, p[0], p[1], 0.5);
  }
  const TetMesh mesh = builtApart(grid);
  EXPECT_EQ(mesh.BoundaryFaces.size(), 2u * 6 * 9);
  EXPECT_EQ(inwardSide(mesh, 5), 0);
}

TEST(Convexity, ConvexMeshes)
{
  for (int n : { 1, 2, 5 })
  {
    EXPECT_TRUE(isConvex(built(jitteredLattice(n, 0.0))));
    EXPECT_TRUE(isConvex(built(jitteredLattice(n))));
  }
  EXPECT_TRUE(isConvex(built(singleTet())));
  EXPECT_TRUE(isConvex(built(shuffled(jitteredLattice(4)))));
  EXPECT_TRUE(isConvex(built(hexLattice(4, 0.15))));
  EXPECT_TRUE(isConvex(built(mixedCells(4, 1, 0.1))));
  EXPECT_TRUE(isConvex(built(quadraticTetLattice(2, 0.1))));
  EXPECT_TRUE(isConvex(built(withOffsetAndScale(jitteredLattice(4), { 1e6, 1e6, -1e6 }, 1.0))));
  EXPECT_TRUE(isConvex(built(splitFacePolyhedron())));
  EXPECT_FALSE(built(jitteredLattice(2)).MayReenter);
}

TEST(Convexity, MeshesThatRaysCanLeaveAndEnterAgain)
{
  EXPECT_FALSE(isConvex(built(latticeWithHole(3))));
  EXPECT_FALSE(isConvex(built(latticeWithTunnel(3))));
  EXPECT_FALSE(isConvex(built(lShape(2))));
  EXPECT_FALSE(isConvex(built(twoComponents(2))));
  EXPECT_FALSE(isConvex(built(nestedShells(8))));
  EXPECT_FALSE(isConvex(built(twoTetsSharingEdge())));
  EXPECT_FALSE(isConvex(built(twoTetsSharingVertex())));
  EXPECT_FALSE(isConvex(built(hexagonalPrismLattice(2))));
  EXPECT_TRUE(built(lShape(2)).MayReenter);
  // Two boxes, each convex, in two places.
  EXPECT_FALSE(isConvex(
    built(joined(jitteredLattice(2), withOffsetAndScale(jitteredLattice(2), { 5, 0, 0 }, 1)))));
}

// A dent is found down to the rounding of positions.
TEST(Convexity, ShallowDents)
{
  const auto dented = [](double depth)
  {
    const Grid grid = jitteredLattice(2, 0.0);
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      double p[3];
      grid->GetPoint(i, p);
      if (p[0] == 0.5 && p[1] == 0.5 && p[2] == 1.0)
      {
        grid->GetPoints()->SetPoint(i, 0.5, 0.5, 1.0 - depth);
      }
    }
    return built(grid);
  };
  EXPECT_FALSE(isConvex(dented(0.1)));
  EXPECT_FALSE(isConvex(dented(1e-4)));
  EXPECT_FALSE(isConvex(dented(2e-6)));
  EXPECT_TRUE(isConvex(dented(0.0)));
}

// Edges that both faces run through in the same direction give it away: inverted
// tetrahedra fold the flat boundary, and a ray meets it three times.
TEST(Convexity, FoldedBoundariesAreNotConvex)
{
  EXPECT_FALSE(isConvex(built(jitteredLattice(4, 0.45))));
}

// The two faces at each side of the square face away from each other, in one plane.
TEST(Convexity, AFlatTetrahedronIsFolded)
{
  const Grid grid = singleTet();
  const double square[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  for (vtkIdType i = 0; i < 4; ++i)
  {
    grid->GetPoints()->SetPoint(i, square[i][0], square[i][1], 0.0);
  }
  EXPECT_FALSE(isConvex(built(grid)));
}
} // namespace
