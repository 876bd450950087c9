// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells become tetrahedra that fill them, and meet face to face.
#include "Mesh/Decomposition.h"
#include "Mesh/MeshScalars.h"

#include "GridSummary.h"
#include "UnitMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

Decomposition decomposed(vtkUnstructuredGrid* grid)
{
  Decomposition result;
  bool stopped = false;
  EXPECT_EQ(decompose(grid, {}, result, stopped), "");
  EXPECT_FALSE(stopped);
  EXPECT_EQ(result.Cells.size(), result.Tets.size());
  EXPECT_EQ(result.CenterCells.size(), result.CenterPositions.size());
  return result;
}

Vec3 positionOf(vtkUnstructuredGrid* grid, const Decomposition& tets, Id id)
{
  if (id >= grid->GetNumberOfPoints())
  {
    return tets.CenterPositions[id - grid->GetNumberOfPoints()];
  }
  Vec3 p;
  grid->GetPoint(id, p.data());
  return p;
}

// Volume of every tetrahedron, added up by cell; the sum of the absolute ones is the volume of the
// cell only if none overlap.
std::vector<double> cellVolumes(vtkUnstructuredGrid* grid, const Decomposition& tets)
{
  std::vector<double> volumes(grid->GetNumberOfCells(), 0.0);
  for (std::size_t t = 0; t < tets.Tets.size(); ++t)
  {
    Vec3 p[4];
    for (int i = 0; i < 4; ++i)
    {
      p[i] = positionOf(grid, tets, tets.Tets[t][i]);
      for (int k = 0; i > 0 && k < 3; ++k)
      {
        p[i][k] -= p[0][k];
      }
    }
    volumes[tets.Cells[t]] += std::abs(p[1][0] * (p[2][1] * p[3][2] - p[2][2] * p[3][1]) +
                                       p[1][1] * (p[2][2] * p[3][0] - p[2][0] * p[3][2]) +
                                       p[1][2] * (p[2][0] * p[3][1] - p[2][1] * p[3][0])) /
                              6.0;
  }
  return volumes;
}

double sumOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum;
}

// Faces of one tetrahedron; every face has at most two.
std::set<std::set<Id>> boundaryOf(const Decomposition& tets)
{
  std::map<std::set<Id>, int> users;
  for (const auto& tet : tets.Tets)
  {
    for (int i = 0; i < 4; ++i)
    {
      ++users[{ tet[(i + 1) % 4], tet[(i + 2) % 4], tet[(i + 3) % 4] }];
    }
  }
  std::set<std::set<Id>> boundary;
  for (const auto& [face, count] : users)
  {
    EXPECT_LE(count, 2);
    if (count == 1)
    {
      boundary.insert(face);
    }
  }
  return boundary;
}

// Cells of a grid without a gap or an overlap keep their volumes, and their boundary is that of the
// grid, cut in triangles.
void expectFillsCells(vtkUnstructuredGrid* grid, bool flatFaces, std::size_t boundaryTriangles)
{
  const Decomposition tets = decomposed(grid);
  const std::vector<double> volumes = cellVolumes(grid, tets);
  const GridSummary summary = summarise(grid);
  // The cells' volumes agree one by one where faces are flat, else only their sum. Which way faces
  // look is VTK's: it turned those of quadratic wedges round in 9.4.
  EXPECT_NEAR(sumOf(volumes), std::abs(summary.Volume), 1e-12);
  for (vtkIdType i = 0; flatFaces && i < grid->GetNumberOfCells(); ++i)
  {
    ASSERT_NEAR(volumes[i], std::abs(volumeOf(grid, facesOf(grid->GetCell(i)))), 1e-13);
  }
  EXPECT_EQ(boundaryOf(tets).size(), boundaryTriangles);
  EXPECT_EQ(tets.Report.UnsupportedCells, 0);
}

TEST(Decomposition, LinearCellsFillTheirVolumes)
{
  for (const double warp : { 0.0, 0.1, 0.15 })
  {
    SCOPED_TRACE(warp);
    const bool flat = warp == 0.0;
    expectFillsCells(hexLattice(4, warp), flat, 2 * 6 * 16);
    expectFillsCells(wedgeLattice(4, warp), flat, 2 * 6 * 16);
    expectFillsCells(pyramidLattice(4, warp), flat, 2 * 6 * 16);
    expectFillsCells(polyhedronLattice(4, warp), flat, 2 * 6 * 16);
    for (const int n : { 3, 4, 6 })
    {
      expectFillsCells(mixedCells(n, 1, warp), flat, 2 * 6 * n * n);
    }
  }
  expectFillsCells(voxelLattice(4), true, 2 * 6 * 16);
  expectFillsCells(jitteredLattice(4), true, 2 * 6 * 16);
  expectFillsCells(hexLattice(1), true, 12);
}

TEST(Decomposition, Prisms)
{
  for (const int n : { 1, 2, 3 })
  {
    const int outline = 6 * n * n - 2 * ((n - 1) * n + (n - 1) * (2 * n - 1));
    // A hexagon is four triangles, a pentagon three, a side two.
    expectFillsCells(hexagonalPrismLattice(n), true, 2 * n * n * 4 + 2 * outline * n);
    expectFillsCells(
      pentagonalPrismLattice(n), true, 2 * 2 * n * n * 3 + 2 * (outline + 2 * n) * n);
  }
}

TEST(Decomposition, QuadraticCells)
{
  for (const double curvature : { 0.0, 0.1 })
  {
    SCOPED_TRACE(curvature);
    const bool flat = curvature == 0.0;
    const int n = 3;
    // A triangle with points on its edges is cut in four, a quadrilateral in four corners and a
    // quadrilateral, or, with a point in its middle, in four quadrilaterals.
    expectFillsCells(quadraticTetLattice(n, curvature), flat, 6 * n * n * 8);
    expectFillsCells(quadraticHexLattice(n, curvature), flat, 6 * n * n * 6);
    expectFillsCells(triQuadraticHexLattice(n, curvature), flat, 6 * n * n * 8);
    expectFillsCells(quadraticWedgeLattice(n, curvature), flat, 4 * n * n * 6 + 2 * n * n * 8);
    expectFillsCells(quadraticPyramidLattice(n, curvature), flat, 6 * n * n * 6);
  }
}

TEST(Decomposition, PolyhedraWithSplitFaces)
{
  const Grid grid = splitFacePolyhedron();
  const Decomposition tets = decomposed(grid);
  EXPECT_NEAR(sumOf(cellVolumes(grid, tets)), 2.0, 1e-14);
  // The outer surface: a quadrilateral of the polyhedron, four faces that the corners of the split
  // one make pentagons, and 12 sides of hexahedra.
  EXPECT_EQ(boundaryOf(tets).size(), 2u + 4 * 3 + 12 * 2);
}

// A step: the prism over the L with its corner cut out at (1, 1), its points in an order in which
// the first doesn't see all faces.
Grid step(const Vec3& moved = { 0.0, 0.0, 0.0 })
{
  GridBuilder builder;
  const double outline[6][2] = { { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 }, { 0, 0 } };
  for (int k = 0; k < 2; ++k)
  {
    for (const auto& p : outline)
    {
      builder.addPoint({ p[0] + moved[0], p[1] + moved[1], k + moved[2] });
    }
  }
  std::vector<Ids> faces = { { 5, 4, 3, 2, 1, 0 }, { 6, 7, 8, 9, 10, 11 } };
  for (vtkIdType i = 0; i < 6; ++i)
  {
    faces.push_back({ i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6 });
  }
  builder.addPolyhedron(faces);
  return builder.finish(linearField());
}

TEST(Decomposition, NonConvexPolyhedronGoesThroughItsCentre)
{
  const Grid grid = step();
  const Decomposition tets = decomposed(grid);
  ASSERT_EQ(tets.CenterCells.size(), 1u);
  EXPECT_EQ(tets.CenterCells[0], 0u);
  for (const auto& tet : tets.Tets)
  {
    EXPECT_EQ(tet[3], Id(grid->GetNumberOfPoints()));
  }
}

TEST(Decomposition, LinearFieldsStayLinear)
{
  for (const Grid& grid : { quadraticHexLattice(2, 0.1), quadraticWedgeLattice(2, 0.1), step() })
  {
    const Field field = linearField();
    TetMesh mesh = built(grid);
    ASSERT_FALSE(mesh.CenterCells.empty());
    const ScalarRange range = readScalars(grid, { grid->GetPointData()->GetScalars() }, mesh).Range;
    for (const Vertex& v : mesh.Vertices)
    {
      const double x = mesh.Frame.Center[0] + mesh.Frame.Radius * double(v.X);
      const double y = mesh.Frame.Center[1] + mesh.Frame.Radius * double(v.Y);
      const double z = mesh.Frame.Center[2] + mesh.Frame.Radius * double(v.Z);
      // Positions and scalars are rounded to float: half an ulp of 1 each.
      ASSERT_NEAR(range.Low + range.width() * double(v.Scalar), field(x, y, z),
        std::ldexp(1.0, -24) * (mesh.Frame.Radius + range.width()));
    }
  }
}

TEST(Decomposition, OtherDimensionsAreSkippedAndCounted)
{
  const Decomposition none = decomposed(triangleAndLineGrid());
  EXPECT_TRUE(none.Tets.empty());
  EXPECT_EQ(none.Report.LowDimensionalCells, 4);
  const Decomposition some = decomposed(mixedDimensions(3));
  EXPECT_EQ(some.Tets.size(), 162u);
  EXPECT_EQ(some.Report.LowDimensionalCells, 20);
  EXPECT_TRUE(decomposed(emptyGrid()).Tets.empty());
  EXPECT_TRUE(decomposed(Grid::New()).Tets.empty());
}
} // namespace
