// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Lagrange and Bezier cells whose points, degrees and weights don't go together.
#include "Input/GridCheck.h"

#include "BrokenGrids.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

TEST(HigherOrderCheck, HigherOrderCellsOfNoDegree)
{
  const std::vector<std::pair<int, std::string>> kinds = { { VTK_LAGRANGE_HEXAHEDRON,
                                                             "vtkLagrangeHexahedron" },
    { VTK_BEZIER_HEXAHEDRON, "vtkBezierHexahedron" }, { VTK_LAGRANGE_WEDGE, "vtkLagrangeWedge" },
    { VTK_BEZIER_WEDGE, "vtkBezierWedge" }, { VTK_LAGRANGE_TETRAHEDRON, "vtkLagrangeTetra" },
    { VTK_BEZIER_TETRAHEDRON, "vtkBezierTetra" } };
  for (const auto& kind : kinds)
  {
    expectError(gridOf({ Tet, { kind.first, Ids(9, 0) } }),
      { "offsets", "cell 1", kind.second, "9 points", "no degree" });
    expectError(
      gridOf({ { kind.first, Ids(3, 0) } }), { "cell 0", kind.second, "3 points", "at least" });
  }
  expectSound(gridOf({ { VTK_LAGRANGE_TETRAHEDRON, { 0, 1, 3, 4 } } }), 1);
  EXPECT_GT(
    built(gridOf({ { VTK_LAGRANGE_HEXAHEDRON, Hexahedron.second } }).grid()).Tets.size(), 4u);
}

TEST(HigherOrderCheck, HigherOrderDegrees)
{
  const Ids corners = Hexahedron.second;
  const auto gridWith =
    [&](int type, const Ids& ids, int components, const std::vector<double>& values)
  {
    const Grid grid = gridOf({ { type, ids } }).grid();
    vtkNew<vtkDoubleArray> degrees;
    degrees->SetName("degrees");
    degrees->SetNumberOfComponents(components);
    for (const double value : values)
    {
      degrees->InsertNextValue(value);
    }
    grid->GetCellData()->SetHigherOrderDegrees(degrees);
    return grid;
  };
  EXPECT_EQ(checkGrid(gridWith(VTK_LAGRANGE_HEXAHEDRON, corners, 3, { 1, 1, 1 })), "");
  EXPECT_EQ(checkGrid(gridWith(VTK_LAGRANGE_HEXAHEDRON, Ids(12, 0), 3, { 2, 1, 1 })), "");
  EXPECT_EQ(checkGrid(gridWith(VTK_LAGRANGE_WEDGE, Ids(9, 0), 3, { 1, 1, 2 })), "");
  EXPECT_EQ(checkGrid(gridWith(VTK_BEZIER_WEDGE, Ids(21, 0), 3, { 2, 2, 2 })), "");
  expectError(gridWith(VTK_LAGRANGE_HEXAHEDRON, corners, 3, { 2, 1, 1 }),
    { "\"degrees\"", "2, 1, 1", "cell 0", "8 points" });
  for (const double wrong : { 0.0, -2.0, 1.5, 1e9, std::nan("") })
  {
    expectError(gridWith(VTK_BEZIER_HEXAHEDRON, corners, 3, { wrong, 1, 1 }),
      { "\"degrees\"", "cell 0", "vtkBezierHexahedron" });
  }
  expectError(
    gridWith(VTK_LAGRANGE_WEDGE, Ids(9, 0), 3, { 1, 2, 2 }), { "\"degrees\"", "1, 2, 2" });
  expectError(
    gridWith(VTK_LAGRANGE_WEDGE, Ids(21, 0), 3, { 1, 1, 1 }), { "\"degrees\"", "21 points" });
  expectError(
    gridWith(VTK_LAGRANGE_HEXAHEDRON, corners, 3, {}), { "\"degrees\"", "0 tuples", "cell 0" });
}

TEST(HigherOrderCheck, RationalWeights)
{
  const auto gridWith = [](vtkIdType tuples)
  {
    const Grid grid = gridOf({ { VTK_BEZIER_HEXAHEDRON, Hexahedron.second } }).grid();
    vtkNew<vtkDoubleArray> weights;
    weights->SetName("weights");
    weights->SetNumberOfTuples(tuples);
    weights->Fill(1.0);
    grid->GetPointData()->SetRationalWeights(weights);
    return grid;
  };
  EXPECT_EQ(checkGrid(gridWith(8)), "");
  expectError(gridWith(7), { "\"weights\"", "7 tuples", "cell 0", "8 points" });
}
} // namespace
