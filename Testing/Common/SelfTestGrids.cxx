// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The generators of grids: volumes, matching faces, counts, and that nothing depends on the
// platform.
#include "GridSummary.h"
#include "Grids.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkPointData.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>

namespace
{
using namespace tetmarch::testing;

bool onCube(vtkUnstructuredGrid* grid, const Ids& face)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { 0.0, 1.0 })
    {
      if (std::all_of(face.begin(), face.end(),
            [&](vtkIdType id) { return grid->GetPoint(id)[axis] == side; }))
      {
        return true;
      }
    }
  }
  return false;
}

// The grid conforms, fills the unit cube, and each cell has its points in VTK's order. turned:
// VTK's faces look inwards.
void expectFillsCube(vtkUnstructuredGrid* grid, std::map<int, vtkIdType> types, bool turned = false)
{
  const GridSummary summary = summarise(grid);
  EXPECT_NEAR(summary.Volume, turned ? -1.0 : 1.0, 1e-12);
  EXPECT_GT(turned ? -summary.LeastVolume : summary.LeastVolume, 0.0);
  EXPECT_EQ(summary.FacesOfMore, 0);
  if (!types.empty())
  {
    EXPECT_EQ(summary.Types, types);
  }
  for (const Ids& face : summary.Boundary)
  {
    ASSERT_TRUE(onCube(grid, face)) << "a face inside the cube has one cell only";
  }
  EXPECT_EQ(grid->GetPointData()->GetScalars()->GetNumberOfTuples(), grid->GetNumberOfPoints());
  EXPECT_EQ(grid->GetCellData()->GetScalars()->GetNumberOfTuples(), grid->GetNumberOfCells());
  EXPECT_STREQ(grid->GetPointData()->GetScalars()->GetName(), "f");
  EXPECT_STREQ(grid->GetCellData()->GetScalars()->GetName(), "c");
}

TEST(Grids, FewTets)
{
  const auto expect =
    [](vtkUnstructuredGrid* grid, double volume, vtkIdType boundary, std::set<vtkIdType> shared)
  {
    const GridSummary summary = summarise(grid);
    EXPECT_DOUBLE_EQ(summary.Volume, volume);
    EXPECT_GT(summary.LeastVolume, 0.0);
    EXPECT_EQ(summary.FacesOnBoundary, boundary);
    if (grid->GetNumberOfCells() == 2)
    {
      const vtkIdType* ids[2];
      vtkIdType count;
      std::set<vtkIdType> both[2];
      for (int c = 0; c < 2; ++c)
      {
        grid->GetCells()->GetCellAtId(c, count, ids[c]);
        both[c].insert(ids[c], ids[c] + 4);
      }
      std::set<vtkIdType> common;
      std::set_intersection(both[0].begin(), both[0].end(), both[1].begin(), both[1].end(),
        std::inserter(common, common.end()));
      EXPECT_EQ(common, shared);
    }
  };
  expect(singleTet(), 1.0 / 6.0, 4, {});
  expect(twoTetsSharingFace(), 0.5, 6, { 1, 2, 3 });
  expect(twoTetsSharingEdge(), 1.0 / 3.0, 8, { 0, 3 });
  expect(twoTetsSharingVertex(), 1.0 / 3.0, 8, { 0 });
}

TEST(Grids, JitteredLattice)
{
  expectFillsCube(jitteredLattice(4, 0.0), { { VTK_TETRA, 384 } });
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    expectFillsCube(jitteredLattice(6, 1.0 / 6.0, seed, noiseField()), { { VTK_TETRA, 1296 } });
  }
  // The same everywhere: expected values from CPython's Mersenne twister with the same state.
  // Lattice point (1, 1, 1) of n = 4 is number 31 and gets the draws 93, 94, 95.
  double p[3];
  jitteredLattice(4, 0.125, 5489)->GetPoint(31, p);
  EXPECT_DOUBLE_EQ(p[0], 0.24922305792279076);
  EXPECT_DOUBLE_EQ(p[1], 0.25914456321334);
  EXPECT_DOUBLE_EQ(p[2], 0.26837343571241945);
}

TEST(Grids, CellTypes)
{
  for (const double warp : { 0.0, 0.1 })
  {
    expectFillsCube(hexLattice(4, warp), { { VTK_HEXAHEDRON, 64 } });
    expectFillsCube(wedgeLattice(4, warp), { { VTK_WEDGE, 128 } });
    expectFillsCube(pyramidLattice(4, warp), { { VTK_PYRAMID, 384 } });
    expectFillsCube(polyhedronLattice(4, warp), { { VTK_POLYHEDRON, 64 } });
  }
  expectFillsCube(voxelLattice(4), { { VTK_VOXEL, 64 } });
}

TEST(Grids, Honeycombs)
{
  for (const int n : { 1, 2, 4 })
  {
    for (const bool hexagons : { true, false })
    {
      const GridSummary summary =
        summarise(hexagons ? hexagonalPrismLattice(n) : pentagonalPrismLattice(n));
      EXPECT_NEAR(summary.Volume, honeycombVolume(n), 1e-12);
      EXPECT_NEAR(
        summary.LeastVolume, honeycombVolume(n) / (n * n * n * (hexagons ? 1 : 2)), 1e-12);
      EXPECT_EQ(summary.FacesOfMore, 0);
      // Bases above and below, and the sides of the outline of n x n hexagons: each has six, and
      // the hexagons have (n-1)n + (n-1)(2n-1) neighbours. The cut adds one face for each half of a
      // cut side.
      const int outline = 6 * n * n - 2 * ((n - 1) * n + (n - 1) * (2 * n - 1));
      const int expected = hexagons ? 2 * n * n + outline * n : 4 * n * n + (outline + 2 * n) * n;
      EXPECT_EQ(summary.FacesOnBoundary, expected) << n << (hexagons ? " hexagons" : " pentagons");
    }
  }
}

TEST(Grids, SplitFacePolyhedron)
{
  const GridSummary summary = summarise(splitFacePolyhedron());
  EXPECT_NEAR(summary.Volume, 2.0, 1e-14);
  EXPECT_NEAR(summary.LeastVolume, 0.25, 1e-14);
  EXPECT_EQ(summary.FacesInside, 8);
  EXPECT_EQ(summary.FacesOnBoundary, 5 + 4 * 3);
}

TEST(Grids, MixedCells)
{
  for (const int n : { 3, 4, 6 })
  {
    for (const double warp : { 0.0, 0.1 })
    {
      const Grid grid = mixedCells(n, 1, warp);
      expectFillsCube(grid, {});
      EXPECT_EQ(summarise(grid).Types.size(), 4u) << n;
    }
  }
}

TEST(Grids, Quadratic)
{
  const bool turned =
    vtkVersion::GetVTKMajorVersion() * 100 + vtkVersion::GetVTKMinorVersion() >= 904;
  for (const double curvature : { 0.0, 0.1 })
  {
    expectFillsCube(quadraticTetLattice(3, curvature), { { VTK_QUADRATIC_TETRA, 162 } });
    expectFillsCube(quadraticHexLattice(3, curvature), { { VTK_QUADRATIC_HEXAHEDRON, 27 } });
    expectFillsCube(triQuadraticHexLattice(3, curvature), { { VTK_TRIQUADRATIC_HEXAHEDRON, 27 } });
    expectFillsCube(quadraticWedgeLattice(3, curvature), { { VTK_QUADRATIC_WEDGE, 54 } }, turned);
    expectFillsCube(quadraticPyramidLattice(3, curvature), { { VTK_QUADRATIC_PYRAMID, 162 } });
  }
}

// Nodes 0 and 1 of every edge that VTK names, then the node in their middle; likewise the faces'
// nodes.
TEST(Grids, QuadraticNodesInVtksOrder)
{
  const auto expectLastInMean = [](vtkCell* part, int corners)
  {
    double mean[3] = { 0.0, 0.0, 0.0 };
    double last[3];
    part->GetPoints()->GetPoint(part->GetNumberOfPoints() - 1, last);
    for (int i = 0; i < corners; ++i)
    {
      for (int a = 0; a < 3; ++a)
      {
        mean[a] += part->GetPoints()->GetPoint(i)[a] / corners;
      }
    }
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_NEAR(last[a], mean[a], 1e-15) << part->GetClassName();
    }
  };
  for (const Grid& grid : { quadraticTetLattice(1), quadraticHexLattice(1),
         triQuadraticHexLattice(1), quadraticWedgeLattice(1), quadraticPyramidLattice(1) })
  {
    vtkCell* cell = grid->GetCell(0);
    for (int e = 0; e < cell->GetNumberOfEdges(); ++e)
    {
      expectLastInMean(cell->GetEdge(e), 2);
    }
    if (cell->GetCellType() == VTK_TRIQUADRATIC_HEXAHEDRON)
    {
      for (int f = 0; f < 6; ++f)
      {
        expectLastInMean(cell->GetFace(f), 4);
      }
      expectLastInMean(cell, 8);
    }
  }
}

TEST(Grids, NonConvex)
{
  const auto expect = [](vtkUnstructuredGrid* grid, double volume)
  {
    const GridSummary summary = summarise(grid);
    EXPECT_NEAR(summary.Volume, volume, 1e-12);
    EXPECT_GT(summary.LeastVolume, 0.0);
    EXPECT_EQ(summary.FacesOfMore, 0);
    std::set<vtkIdType> used;
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      vtkIdType count;
      const vtkIdType* ids;
      grid->GetCells()->GetCellAtId(i, count, ids);
      used.insert(ids, ids + count);
    }
    EXPECT_EQ(static_cast<vtkIdType>(used.size()), grid->GetNumberOfPoints());
    return summary;
  };
  EXPECT_EQ(expect(latticeWithHole(6), 1.0 - 8.0 / 216).FacesOnBoundary, 2 * 6 * (36 + 4));
  EXPECT_EQ(
    expect(latticeWithTunnel(6), 1.0 - 24.0 / 216).FacesOnBoundary, 2 * (4 * 36 + 2 * 32 + 4 * 12));
  EXPECT_EQ(expect(lShape(6), 0.75).FacesOnBoundary, 2 * (2 * 27 + 4 * 36));
  EXPECT_EQ(expect(twoComponents(4), 1.125).FacesOnBoundary, 2 * (2 * 6 * 16));
  const GridSummary shells = expect(nestedShells(12), summarise(nestedShells(12, 4, 0.0)).Volume);
  EXPECT_GT(shells.Volume, 0.3);
  EXPECT_LT(shells.Volume, 0.7);
}

TEST(Grids, NotVolumes)
{
  EXPECT_EQ(emptyGrid()->GetNumberOfCells(), 0);
  EXPECT_EQ(emptyGrid()->GetPointData()->GetNumberOfArrays(), 0);
  const Grid flat = triangleAndLineGrid();
  for (vtkIdType i = 0; i < flat->GetNumberOfCells(); ++i)
  {
    EXPECT_LT(flat->GetCell(i)->GetCellDimension(), 3);
  }
  EXPECT_EQ(summarise(mixedDimensions(3)).Types,
    (std::map<int, vtkIdType>{
      { VTK_VERTEX, 1 }, { VTK_LINE, 1 }, { VTK_TRIANGLE, 18 }, { VTK_TETRA, 162 } }));
  EXPECT_EQ(defectiveTets()->GetNumberOfCells(), 5);
}

TEST(Grids, Transforms)
{
  const Grid grid = jitteredLattice(6, 0.15, 1, noiseField());
  const Grid mixed = shuffled(grid, 7);
  const GridSummary before = summarise(grid);
  const GridSummary after = summarise(mixed);
  EXPECT_EQ(after.FacesInside, before.FacesInside);
  EXPECT_EQ(after.FacesOnBoundary, before.FacesOnBoundary);
  EXPECT_LT(after.LeastVolume, 0.0);
  // The values are still those of the field at the points.
  const Grid again = withCells32(mixed);
  attachFields(again, noiseField());
  double inverted = 0.0;
  for (vtkIdType i = 0; i < mixed->GetNumberOfCells(); ++i)
  {
    EXPECT_NEAR(again->GetCellData()->GetScalars()->GetTuple1(i),
      mixed->GetCellData()->GetScalars()->GetTuple1(i), 1e-12);
    inverted += volumeOf(mixed, facesOf(mixed->GetCell(i))) < 0.0;
  }
  EXPECT_NEAR(inverted / static_cast<double>(mixed->GetNumberOfCells()), 0.5, 0.05);
  for (vtkIdType i = 0; i < mixed->GetNumberOfPoints(); ++i)
  {
    EXPECT_DOUBLE_EQ(again->GetPointData()->GetScalars()->GetTuple1(i),
      mixed->GetPointData()->GetScalars()->GetTuple1(i));
  }
  EXPECT_FALSE(again->GetCells()->IsStorage64Bit());
  EXPECT_NEAR(summarise(again).Volume, after.Volume, 1e-14);

  EXPECT_NEAR(summarise(withOffsetAndScale(grid, { 3.0, -2.0, 5.0 }, 2.0)).Volume, 8.0, 1e-10);
  const Grid single = withFloatPoints(grid);
  EXPECT_EQ(single->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(grid->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_NEAR(summarise(single).Volume, 1.0, 1e-5);
}
} // namespace
