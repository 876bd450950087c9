// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whatever the arrays of a grid hold, nothing is read that isn't there, and the error names the
// array, the cell or point, the value and what it may be.
#include "Input/GridCheck.h"

#include "BrokenGrids.h"

#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

TEST(GridCheck, SoundGridsPass)
{
  for (const NamedGrid& named : everyGrid())
  {
    const Grid grid = named.Make();
    EXPECT_EQ(checkGrid(grid), "") << named.Name;
    RawGrid raw(grid);
    for (const bool wide : { false, true })
    {
      raw.Wide = wide;
      EXPECT_EQ(checkGrid(raw.grid()), "") << named.Name;
    }
  }
  EXPECT_EQ(checkGrid(emptyGrid()), "");
  EXPECT_EQ(checkGrid(triangleAndLineGrid()), "");
  expectSound(gridOf({ Tet, Hexahedron }), 7);
}

TEST(GridCheck, IdsBeyondThePoints)
{
  expectError(gridOf({ Tet, { VTK_TETRA, { 0, 1, 2, 8 } } }),
    { "connectivity", "cell 1", "point 8", "8 points" });
  expectError(gridOf({ Hexahedron, { VTK_TETRA, { 0, -1, 2, 3 } } }),
    { "connectivity", "cell 1", "point -1" });
  expectError(gridOf({ { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 0x7fffffff } } }),
    { "cell 0", "point 2147483647" });
  expectError(gridOf({ { VTK_TRIANGLE, { 0, 1, 99 } }, Tet }), { "cell 0", "point 99" });
  RawGrid wide = gridOf({ Tet });
  wide.Connectivity[2] = vtkIdType(1) << 32; // 0 in its lower half
  expectError(wide.grid(), { "cell 0", "point 4294967296" });
}

TEST(GridCheck, TheFirstOfSeveralErrorsIsTold)
{
  std::vector<std::pair<int, Ids>> cells(5000, Tet);
  cells[1234].second[3] = 1000;
  cells[4321].second[0] = -5;
  expectError(gridOf(cells), { "cell 1234", "point 1000" });
}

TEST(GridCheck, OffsetsThatDescend)
{
  RawGrid raw = gridOf({ Hexahedron, Tet, Tet });
  raw.Offsets = { 0, 8, 4, 12 };
  expectError(raw, { "offsets", "cell 1", "begin at 8", "end at 4", "not descend" });
}

TEST(GridCheck, OffsetsBeyondTheConnectivity)
{
  RawGrid raw = gridOf({ Tet, Tet });
  raw.Offsets = { 0, 4, 9 };
  expectError(raw, { "offsets", "cell 1", "end at 9", "8 values" });
  raw.Offsets = { 0, 4, 0x7ffffffc };
  expectError(raw, { "cell 1", "2147483644" });
  raw.Offsets = { 0, VTK_ID_MAX, VTK_ID_MAX };
  expectError(raw.grid(), { "cell 0", std::to_string(VTK_ID_MAX) });
}

TEST(GridCheck, OffsetsThatAreNegativeOrDontBeginWithZero)
{
  RawGrid raw = gridOf({ Tet, Tet });
  raw.Offsets = { -4, 0, 4 };
  expectError(raw, { "offsets", "cell 0", "begin at -4", "begin with 0" });
  raw.Offsets = { 4, 8, 8 };
  expectError(raw, { "offsets", "cell 0", "begin at 4" });
  raw.Offsets = { 0, -4, 4 };
  expectError(raw, { "cell 0", "end at -4" });
  raw.Offsets = { VTK_ID_MIN, 0, 4 };
  expectError(raw.grid(), { "cell 0", std::to_string(VTK_ID_MIN) });
}

TEST(GridCheck, OffsetsOfAnotherNumberOfCells)
{
  RawGrid raw = gridOf({ Tet, Tet, Tet });
  raw.Offsets.pop_back();
  expectError(raw, { "2 cells", "3 cell types" });
  raw.Offsets = { 0, 4, 8, 12, 12, 12 };
  expectError(raw, { "5 cells", "3 cell types" });
  raw.Offsets.clear();
  expectError(raw, { "offsets", "empty" });
}

TEST(GridCheck, ConnectivityBehindTheLastCellIsNotRead)
{
  RawGrid raw = gridOf({ Tet });
  raw.Connectivity.push_back(-77);
  expectSound(raw, 1);
}

TEST(GridCheck, NumbersOfPoints)
{
  expectError(gridOf({ Tet, { VTK_TETRA, { 0, 1, 2 } } }),
    { "offsets", "cell 1", "vtkTetra", "3 points", "4" });
  expectError(gridOf({ { VTK_TETRA, {} } }), { "cell 0", "0 points" });
  expectError(gridOf({ { VTK_TETRA, { 0, 1, 2, 3, 4 } } }), { "cell 0", "5 points" });
  const std::vector<std::pair<int, std::string>> fixed = { { VTK_VOXEL, "8" },
    { VTK_HEXAHEDRON, "8" }, { VTK_WEDGE, "6" }, { VTK_PYRAMID, "5" },
    { VTK_PENTAGONAL_PRISM, "10" }, { VTK_HEXAGONAL_PRISM, "12" }, { VTK_QUADRATIC_TETRA, "10" },
    { VTK_QUADRATIC_HEXAHEDRON, "20" }, { VTK_QUADRATIC_WEDGE, "15" },
    { VTK_QUADRATIC_PYRAMID, "13" }, { VTK_TRIQUADRATIC_HEXAHEDRON, "27" },
    { VTK_TRIQUADRATIC_PYRAMID, "19" } };
  for (const auto& type : fixed)
  {
    expectError(gridOf({ Tet, { type.first, { 0, 1, 2, 3, 4, 5, 6 } } }),
      { "offsets", "cell 1", "7 points", "must have " + type.second + "." });
    Ids many(28, 0);
    expectError(gridOf({ { type.first, many } }), { "cell 0", "28 points" });
  }
  for (const int type : { VTK_CONVEX_POINT_SET, VTK_POLYHEDRON })
  {
    expectError(gridOf({ { type, { 0, 1, 2 } } }), { "cell 0", "3 points", "at least 4" });
  }
}

TEST(GridCheck, TypesThatVTKDoesntKnow)
{
  for (const int type : { 17, 20, 38, 40, 43, 50, 57, 59, 82, 128, 255 })
  {
    expectError(gridOf({ Tet, { type, { 0, 1, 2, 3 } } }),
      { "cell types", "cell 1", "say " + std::to_string(type) });
  }
}

TEST(GridCheck, TypesThatAreSkippedOrCounted)
{
  const TetMesh mesh = built(gridOf(
    { { VTK_EMPTY_CELL, {} }, Tet, { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_QUAD, { 0 } },
      { VTK_LAGRANGE_PYRAMID, { 0, 1, 2, 3, 4 } }, { VTK_HIGHER_ORDER_TETRAHEDRON, { 0, 1, 2, 3 } },
      { VTK_PARAMETRIC_HEX_REGION,
        {} } }).grid());
  EXPECT_EQ(mesh.Tets.size(), 1u);
  EXPECT_EQ(mesh.Report.LowDimensionalCells, 2);
  EXPECT_EQ(mesh.Report.UnsupportedCells, 3);
}

TEST(GridCheck, TypesThatDontFitTheCells)
{
  const Grid grid = gridOf({ Tet, Tet }).grid();
  vtkDataArray* types = cellTypesOf(grid);
  types->SetNumberOfComponents(2);
  types->SetNumberOfTuples(2);
  types->Fill(VTK_TETRA);
  expectError(grid, { "2 cells", "2 cell types", "2 components" });
  setCells(grid, nullptr, grid->GetCells(), nullptr, nullptr);
  expectError(grid, { "2 cells", "no cell types" });
}

TEST(GridCheck, PointsMissingOrNotOfThreeComponents)
{
  const Grid grid = gridOf({ Tet }).grid();
  grid->GetPoints()->GetData()->SetNumberOfComponents(2);
  expectError(grid, { "points", "2 components", "3" });
  grid->SetPoints(nullptr);
  expectError(grid, { "1 cells", "no points" });
}

TEST(GridCheck, CoordinatesThatAreNotFiniteOrTooLarge)
{
  const double inf = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
  {
    const std::string coordinate = "Coordinate " + std::to_string(k) + " of point 3";
    RawGrid raw = gridOf({ { VTK_TETRA, { 0, 1, 2, 4 } }, Tet });
    raw.Points[9 + k] = std::nan("");
    expectError(raw, { coordinate, "cell 1", "nan", "not a finite number" });
    raw.Points[9 + k] = -inf;
    expectError(raw, { coordinate, "cell 1", "-inf", "not a finite number" });
    raw.Points[9 + k] = -1e300;
    expectError(raw, { coordinate, "cell 1", "-1e+300", "larger than 1e100" });
    raw.FloatPoints = true; // where that is infinite
    expectError(raw, { coordinate, "cell 1", "-inf" });
  }
}

TEST(GridCheck, PointsThatNo3DCellHasMayBeAnything)
{
  RawGrid raw = gridOf({ Tet, { VTK_TRIANGLE, { 0, 1, 7 } }, { VTK_LAGRANGE_PYRAMID, { 6 } } });
  raw.Points[21] = std::nan("");
  raw.Points[18] = 1e300;
  expectSound(raw, 1);
}

TEST(GridCheck, LargestCoordinates)
{
  RawGrid raw = gridOf({ Tet, Hexahedron });
  for (double& x : raw.Points)
  {
    x = (x - 0.5) * 2e100;
  }
  const TetMesh mesh = built(raw.grid());
  EXPECT_EQ(mesh.Tets.size(), 7u);
  EXPECT_NEAR(mesh.Frame.Radius, std::sqrt(3.0) * 1e100, 1e85);
}

TEST(GridCheck, AllPointsEqual)
{
  RawGrid raw = gridOf({ Tet, Hexahedron });
  std::fill(raw.Points.begin(), raw.Points.end(), 7.0);
  const TetMesh mesh = builtWithHierarchy(raw.grid());
  EXPECT_EQ(mesh.Frame.Radius, 1.0);
  for (const Vertex& v : mesh.Vertices)
  {
    EXPECT_EQ(v.X, 0.0f);
  }
}

TEST(GridCheck, MoreThanCanBeNumbered)
{
  const vtkIdType most = vtkIdType(1) << 31;
  EXPECT_EQ(checkCounts(most - 1, most - 1), "");
  EXPECT_NE(checkCounts(most, 8).find("2147483648 cells and 8 points"), std::string::npos);
  EXPECT_NE(
    checkCounts(8, VTK_ID_MAX).find(std::to_string(VTK_ID_MAX) + " points"), std::string::npos);
}
} // namespace
