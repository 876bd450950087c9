// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Grids that contradict themselves are refused with the cell and the value that is wrong.
#include "Mesh/Decomposition.h"
#include "Mesh/TetMeshBuilder.h"

#include "UnitMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

std::string errorOf(vtkUnstructuredGrid* grid)
{
  TetMesh mesh;
  std::string error;
  const BuildStatus status = buildTetMesh(grid, {}, mesh, error);
  EXPECT_EQ(status == BuildStatus::Failed, !error.empty());
  return error;
}

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

void expectMentions(const std::string& error, const std::vector<std::string>& parts)
{
  for (const std::string& part : parts)
  {
    EXPECT_NE(error.find(part), std::string::npos) << "'" << part << "' in: " << error;
  }
}

TEST(DecompositionErrors, PointsOutOfRange)
{
  const std::pair<int, Ids> good{ VTK_TETRA, { 0, 1, 2, 3 } };
  EXPECT_EQ(errorOf(gridOf({ good, good })), "");
  expectMentions(errorOf(gridOf({ good, good, { VTK_TETRA, { 0, 1, 2, 5 } } })),
    { "cell 2", "point 5", "5 points" });
  expectMentions(
    errorOf(gridOf({ good, { VTK_TETRA, { 0, 1, -7, 3 } } })), { "cell 1", "point -7" });
  expectMentions(
    errorOf(gridOf({ { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 3, 2, 99 } } })), { "cell 0", "point 99" });
  expectMentions(errorOf(gridOf({ { VTK_QUADRATIC_TETRA, { 0, 1, 2, 3, 4, 0, 1, 2, 3, 123 } } })),
    { "cell 0", "point 123" });
}

TEST(DecompositionErrors, WrongNumbersOfPoints)
{
  expectMentions(errorOf(gridOf({ { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2 } } })),
    { "Cell 1", "vtkTetra", "3 points", "4" });
  expectMentions(errorOf(gridOf({ { VTK_TETRA, { 0, 1, 2, 3, 4 } } })), { "Cell 0", "5 points" });
  expectMentions(errorOf(gridOf({ { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4 } } })),
    { "Cell 0", "vtkHexahedron", "5 points", "8" });
  expectMentions(errorOf(gridOf({ { VTK_WEDGE, { 0, 1, 2, 3, 4 } } })), { "Cell 0", "vtkWedge" });
  expectMentions(errorOf(gridOf({ { VTK_PYRAMID, {} } })), { "Cell 0", "0 points" });
  expectMentions(errorOf(gridOf({ { VTK_QUADRATIC_HEXAHEDRON, { 0, 1, 2, 3, 4, 0, 1, 2 } } })),
    { "Cell 0", "vtkQuadraticHexahedron", "8 points", "20" });
}

TEST(DecompositionErrors, FacesOfPolyhedraOutOfRange)
{
  const Grid grid = polyhedronLattice(2);
  grid->GetFaces()->SetValue(grid->GetFaceLocations()->GetValue(3) + 2, 1000);
  expectMentions(errorOf(grid), { "polyhedron 3", "point 1000", "27 points" });
}

TEST(DecompositionErrors, ArraysThatAreMissingOrDontFit)
{
  const Grid noPoints = singleTet();
  noPoints->SetPoints(nullptr);
  EXPECT_NE(errorOf(noPoints), "");

  const Grid fewTypes = jitteredLattice(2);
  vtkNew<vtkUnsignedCharArray> types;
  types->InsertNextValue(VTK_TETRA);
  fewTypes->SetCells(types, fewTypes->GetCells());
  expectMentions(errorOf(fewTypes), { "48 cells", "1 cell types" });
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
