// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A series of grids, each new as a reader makes them: of the same mesh only scalars are redone.
#include "Input/GridVersions.h"
#include "Scene.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr vtkTypeInt64 VertexBytes = 16;

Grid golfBall()
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(TETMARCH_DATA_DIR "/golfball_small.vtu");
  reader->Update();
  const Grid grid = reader->GetOutput();
  grid->GetPointData()->SetActiveScalars("vorticity_mag");
  return grid;
}

// A new grid with new arrays; the scalars change from step to step within the same range.
Grid stepOf(vtkUnstructuredGrid* grid, int step)
{
  auto next = Grid::New();
  next->DeepCopy(grid);
  vtkDataArray* from = grid->GetPointData()->GetScalars();
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName(from->GetName());
  const vtkIdType count = from->GetNumberOfTuples();
  scalars->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    scalars->SetTuple1(i, from->GetTuple1((i + 997 * step) % count));
  }
  next->GetPointData()->SetScalars(scalars);
  return next;
}

void frameGolfBall(Scene& scene)
{
  setWakeFunctions(scene.property());
  scene.Renderer->ResetCamera();
  scene.camera()->Zoom(2.0);
}

TEST(Series, OnlyScalarsAreUploaded)
{
  const Grid first = golfBall();
  Scene scene(first);
  frameGolfBall(scene);
  Image before = scene.render();
  for (int step = 1; step < 4; ++step)
  {
    scene.Data = stepOf(first, step);
    scene.Mapper->SetInputData(scene.Data);
    const vtkTypeInt64 bytes = scene.Mapper->GetUploadedBytes();
    const Image picture = scene.render();
    EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
    EXPECT_EQ(scene.Mapper->GetScalarsBuilds(), step + 1);
    EXPECT_EQ(scene.Mapper->GetTablesBuilds(), 1);
    EXPECT_EQ(
      scene.Mapper->GetUploadedBytes() - bytes, VertexBytes * scene.Data->GetNumberOfPoints());
    EXPECT_GT(compare(picture, before).Max, 0.02);
    before = picture;
    Scene fresh(scene.Data);
    frameGolfBall(fresh);
    EXPECT_EQ(compare(picture, fresh.render()).Max, 0.0);
  }
}

TEST(Series, WhateverTheMeshDependsOnIsMadeAnew)
{
  const Grid first = jitteredLattice(6, 0.15, 1, sineField());
  Scene scene(first);
  const Image before = scene.render();
  const std::vector<std::function<void(vtkUnstructuredGrid*)>> changes = {
    [](vtkUnstructuredGrid* grid)
    {
      vtkDataArray* points = grid->GetPoints()->GetData();
      points->SetComponent(100, 1, std::nextafter(points->GetComponent(100, 1), 2.0));
    },
    [](vtkUnstructuredGrid* grid) { tetmarch::cellTypesOf(grid)->SetComponent(5, 0, VTK_QUAD); },
    [](vtkUnstructuredGrid* grid)
    {
      vtkDataArray* ids = grid->GetCells()->GetConnectivityArray();
      for (int i = 0; i < 4; ++i)
      {
        const double id = ids->GetComponent(i, 0);
        ids->SetComponent(i, 0, ids->GetComponent(400 + i, 0));
        ids->SetComponent(400 + i, 0, id);
      }
    },
  };
  vtkTypeInt64 builds = 1;
  for (const auto& change : changes)
  {
    scene.Data = stepOf(first, 0);
    change(scene.Data);
    scene.Mapper->SetInputData(scene.Data);
    const Image picture = scene.render();
    EXPECT_EQ(scene.Mapper->GetMeshBuilds(), ++builds);
    EXPECT_EQ(compare(picture, Scene(scene.Data).render()).Max, 0.0);
  }
  scene.Mapper->SetInputData(first);
  EXPECT_EQ(compare(scene.render(), before).Max, 0.0);
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), builds + 1);
}

// Vertices keep the order of the first step, which changes nothing of pictures but rounding.
TEST(Series, MovedPointsLookLikeANewMesh)
{
  Scene scene(latticeWithHole(6, 0.15, 1, sineField()));
  scene.render();
  for (int step = 1; step < 6; ++step)
  {
    const Grid next = latticeWithHole(6, 0.15, 1, sineField());
    for (vtkIdType i = 0; i < next->GetNumberOfPoints(); ++i)
    {
      double p[3];
      next->GetPoint(i, p);
      next->GetPoints()->SetPoint(
        i, p[0] + 0.05 * step * p[2] * p[2], p[1], p[2] - 0.04 * step * p[0]);
    }
    scene.Mapper->SetInputData(next);
    scene.camera()->SetClippingRange(step == 5 ? 2.6 : 0.1, 10.0); // through the middle
    const Image picture = scene.render();
    EXPECT_EQ(scene.Mapper->GetMeshBuilds(), step + 1);
    Scene fresh(next);
    fresh.camera()->DeepCopy(scene.camera());
    const Difference difference = compare(picture, fresh.render());
    EXPECT_LE(difference.Max, 1.0 / 255.0);
    EXPECT_EQ(scene.Mapper->GetNumberOfRays(), fresh.Mapper->GetNumberOfRays());
    EXPECT_EQ(scene.Mapper->GetNumberOfLostRays(), 0);
    EXPECT_EQ(scene.Mapper->GetNumberOfGuardHits(), 0);
    EXPECT_EQ(scene.Mapper->GetNumberOfBoundaryFaces(), fresh.Mapper->GetNumberOfBoundaryFaces());
    std::cout << "[ MEASURED ] step " << step << ": " << difference.text() << "\n";
  }
}
} // namespace
