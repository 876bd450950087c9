// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The mesh of a grid is known again in another grid, unless anything that it depends on differs.
#include "Scene/GridContent.h"

#include "Grids.h"
#include "Scene/MeshStage.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;

Grid copyOf(vtkUnstructuredGrid* grid)
{
  auto copy = Grid::New();
  copy->DeepCopy(grid);
  return copy;
}

GridContent contentOf(vtkUnstructuredGrid* grid)
{
  GridContent content;
  content.read(grid);
  return content;
}

bool isKnownAgain(
  vtkUnstructuredGrid* grid, const std::function<void(vtkUnstructuredGrid*)>& change)
{
  const Grid other = copyOf(grid);
  change(other);
  return contentOf(other) == contentOf(grid);
}

vtkTypeInt64Array* connectivityOf(vtkUnstructuredGrid* grid)
{
  return grid->GetCells()->GetConnectivityArray64();
}

TEST(GridContent, IsThatOfACopy)
{
  for (const Grid& grid : { jitteredLattice(3), mixedCells(2), polyhedronLattice(2, 0.1),
         withFloatPoints(jitteredLattice(3)), withCells32(jitteredLattice(3)) })
  {
    EXPECT_TRUE(isKnownAgain(grid, [](vtkUnstructuredGrid*) {}));
  }
  vtkNew<vtkUnstructuredGrid> bare;
  EXPECT_TRUE(contentOf(bare) == contentOf(bare));
}

TEST(GridContent, KnowsNothingOfScalars)
{
  EXPECT_TRUE(isKnownAgain(jitteredLattice(3),
    [](vtkUnstructuredGrid* grid)
    {
      grid->GetPointData()->GetScalars()->Fill(0.5);
      grid->GetCellData()->Initialize();
    }));
}

TEST(GridContent, DiffersByTheLastBitOfAPoint)
{
  const Grid grid = jitteredLattice(3);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_FALSE(isKnownAgain(grid,
      [axis](vtkUnstructuredGrid* moved)
      {
        vtkDataArray* points = moved->GetPoints()->GetData();
        points->SetComponent(17, axis, std::nextafter(points->GetComponent(17, axis), 2.0));
      }));
  }
  EXPECT_FALSE(contentOf(withFloatPoints(grid)) == contentOf(grid));
}

TEST(GridContent, DiffersByACell)
{
  const Grid grid = jitteredLattice(3);
  EXPECT_FALSE(isKnownAgain(grid, [](vtkUnstructuredGrid* other)
    { connectivityOf(other)->SetValue(41, (connectivityOf(other)->GetValue(41) + 1) % 64); }));
  EXPECT_FALSE(isKnownAgain(
    grid, [](vtkUnstructuredGrid* other) { other->GetCellTypesArray()->SetValue(7, VTK_QUAD); }));
  EXPECT_FALSE(isKnownAgain(grid,
    [](vtkUnstructuredGrid* other)
    {
      vtkTypeInt64Array* ids = connectivityOf(other);
      for (int i = 0; i < 4; ++i)
      {
        const vtkTypeInt64 id = ids->GetValue(4 * 10 + i);
        ids->SetValue(4 * 10 + i, ids->GetValue(4 * 99 + i));
        ids->SetValue(4 * 99 + i, id);
      }
    }));
  EXPECT_FALSE(isKnownAgain(mixedCells(2),
    [](vtkUnstructuredGrid* other)
    {
      auto* offsets = other->GetCells()->GetOffsetsArray64();
      offsets->SetValue(3, offsets->GetValue(3) + 1);
    }));
}

TEST(GridContent, DiffersByTheFacesOfPolyhedra)
{
  const Grid grid = polyhedronLattice(2, 0.1);
  EXPECT_FALSE(isKnownAgain(grid,
    [](vtkUnstructuredGrid* other)
    {
      vtkIdTypeArray* faces = other->GetFaces();
      faces->SetValue(2, faces->GetValue(3));
    }));
  EXPECT_FALSE(isKnownAgain(grid, [](vtkUnstructuredGrid* other)
    { other->GetFaceLocations()->SetValue(1, other->GetFaceLocations()->GetValue(0)); }));
}

TEST(GridContent, DiffersByDegreesAndWeights)
{
  vtkNew<vtkDoubleArray> degrees;
  degrees->SetNumberOfComponents(3);
  degrees->SetNumberOfTuples(162);
  degrees->Fill(2.0);
  EXPECT_FALSE(isKnownAgain(jitteredLattice(3), [&degrees](vtkUnstructuredGrid* other)
    { other->GetCellData()->SetHigherOrderDegrees(degrees); }));
  vtkNew<vtkDoubleArray> weights;
  weights->SetNumberOfTuples(64);
  weights->Fill(1.0);
  EXPECT_FALSE(isKnownAgain(jitteredLattice(3), [&weights](vtkUnstructuredGrid* other)
    { other->GetPointData()->SetRationalWeights(weights); }));
}

TEST(GridContent, ArraysModifiedInPlace)
{
  const Grid grid = jitteredLattice(3);
  MeshStage stage;
  ASSERT_EQ(stage.make(grid, {}, {}), "");
  // Told by the array or by what holds it, with values that changed or didn't.
  connectivityOf(grid)->Modified();
  grid->GetPoints()->Modified();
  grid->GetCells()->Modified();
  EXPECT_TRUE(stage.isCurrent(grid));
  const vtkTypeInt64 id = connectivityOf(grid)->GetValue(8);
  connectivityOf(grid)->SetValue(8, (id + 1) % 64);
  connectivityOf(grid)->Modified();
  EXPECT_FALSE(stage.isCurrent(grid));
  connectivityOf(grid)->SetValue(8, id);
  grid->GetCells()->Modified();
  EXPECT_TRUE(stage.isCurrent(grid));
  vtkDataArray* points = grid->GetPoints()->GetData();
  points->SetComponent(5, 0, std::nextafter(points->GetComponent(5, 0), 2.0));
  grid->GetPoints()->Modified();
  EXPECT_FALSE(stage.isCurrent(grid));
}

TEST(GridContent, WhatIsReadAlreadyIsNotReadAgain)
{
  const Grid grid = jitteredLattice(3);
  GridContent content = contentOf(grid);
  const GridContent before = content;
  grid->GetPoints()->GetData()->SetComponent(5, 0, 7.0); // which nobody is told
  content.read(grid);
  EXPECT_TRUE(content == before);
  grid->GetPoints()->GetData()->Modified();
  content.read(grid);
  EXPECT_FALSE(content == before);
}

TEST(GridContent, TheMeshOfASeriesIsMadeOnce)
{
  const Grid first = jitteredLattice(4);
  MeshStage stage;
  ASSERT_EQ(stage.make(first, {}, {}), "");
  for (int step = 0; step < 3; ++step)
  {
    EXPECT_TRUE(stage.isCurrent(copyOf(first)));
  }
  EXPECT_EQ(stage.record().Runs, 1);
  EXPECT_FALSE(stage.isCurrent(jitteredLattice(4, 0.15, 2)));
  EXPECT_TRUE(stage.isCurrent(first)); // nothing was made since
}
} // namespace
