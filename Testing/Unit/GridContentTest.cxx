// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The mesh of a grid is known again in another grid, unless anything that it depends on differs.
#include "Input/GridContent.h"

#include "Grids.h"
#include "Mesh/MeshStage.h"
#include "RawGrid.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

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

vtkDataArray* connectivityOf(vtkUnstructuredGrid* grid)
{
  return grid->GetCells()->GetConnectivityArray();
}

// The next of 64 points.
void changeId(vtkDataArray* ids, vtkIdType at)
{
  ids->SetComponent(at, 0, std::fmod(ids->GetComponent(at, 0) + 1.0, 64.0));
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
  EXPECT_FALSE(
    isKnownAgain(grid, [](vtkUnstructuredGrid* other) { changeId(connectivityOf(other), 41); }));
  EXPECT_FALSE(isKnownAgain(
    grid, [](vtkUnstructuredGrid* other) { cellTypesOf(other)->SetComponent(7, 0, VTK_QUAD); }));
  EXPECT_FALSE(isKnownAgain(grid,
    [](vtkUnstructuredGrid* other)
    {
      vtkDataArray* ids = connectivityOf(other);
      for (int i = 0; i < 4; ++i)
      {
        const double id = ids->GetComponent(4 * 10 + i, 0);
        ids->SetComponent(4 * 10 + i, 0, ids->GetComponent(4 * 99 + i, 0));
        ids->SetComponent(4 * 99 + i, 0, id);
      }
    }));
  EXPECT_FALSE(isKnownAgain(mixedCells(2),
    [](vtkUnstructuredGrid* other)
    {
      vtkDataArray* offsets = other->GetCells()->GetOffsetsArray();
      offsets->SetComponent(3, 0, offsets->GetComponent(3, 0) + 1.0);
    }));
}

TEST(GridContent, DiffersByTheFacesOfPolyhedra)
{
  const Grid grid = polyhedronLattice(2, 0.1);
  RawGrid raw(grid);
  for (const auto& arrays : { raw.Faces.locationArrays(), raw.Faces.faceArrays() })
  {
    for (Ids* array : arrays)
    {
      const vtkIdType id = array->at(2);
      array->at(2) = array->at(3);
      EXPECT_FALSE(contentOf(raw.grid()) == contentOf(grid));
      array->at(2) = id;
    }
  }
  EXPECT_TRUE(contentOf(raw.grid()) == contentOf(grid));
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
  const double id = connectivityOf(grid)->GetComponent(8, 0);
  changeId(connectivityOf(grid), 8);
  connectivityOf(grid)->Modified();
  EXPECT_FALSE(stage.isCurrent(grid));
  connectivityOf(grid)->SetComponent(8, 0, id);
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
