// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Frames of the boundary views: what they do without, and what they leave behind.
#include "BoundaryScene.h"
#include "GLObjects.h"
#include "SameFaces.h"

#include "vtkTetMarchFrameStatistics.h"

#include <gtest/gtest.h>
#include <set>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;

TEST(BoundaryView, BackToThePictureNothingIsLeft)
{
  BoundaryScene scene(latticeWithHole(6));
  scene.Mapper->SetShaderStageToFragment(); // a compute shader's picture takes room, too
  const Image picture = scene.view(Mapper::VIEW_PICTURE);
  const auto objects = countGLObjects();
  const vtkTypeInt64 bytes = scene.Mapper->GetGPUMemoryBytes();
  for (const int mode : { Mapper::VIEW_BOUNDARY_FACES, Mapper::VIEW_BOUNDARY_COORDINATES })
  {
    const Image view = scene.view(mode);
    EXPECT_GT(compare(view, picture).Max, 0.1);
    EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), bytes); // takes none
    EXPECT_EQ(scene.view(mode).Rgba, view.Rgba);
    EXPECT_EQ(scene.view(Mapper::VIEW_PICTURE).Rgba, picture.Rgba);
    EXPECT_EQ(countGLObjects(), objects);
  }
  EXPECT_EQ(scene.Mapper->GetMeshBuilds(), 1);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  const auto released = countGLObjects();
  const Image view = scene.view(Mapper::VIEW_BOUNDARY_FACES);
  EXPECT_NE(countGLObjects(), released);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(countGLObjects(), released);
  EXPECT_EQ(scene.view(Mapper::VIEW_BOUNDARY_FACES).Rgba, view.Rgba);
}

// Turned by a quarter about the middle, the cells of a lattice are what they were, but vertices
// that are numbered by their places have other numbers.
Grid turned(vtkUnstructuredGrid* grid)
{
  auto result = Grid::New();
  result->DeepCopy(grid);
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    double p[3];
    result->GetPoint(i, p);
    result->GetPoints()->SetPoint(i, 1.0 - p[1], p[0], p[2]);
  }
  return result;
}

TEST(BoundaryView, FacesKeepTheirColorsWhilePointsMove)
{
  const Grid grid = boundaryLattice();
  BoundaryScene moved(grid);
  moved.view(Mapper::VIEW_BOUNDARY_FACES);
  const Grid after = turned(grid);
  moved.Mapper->SetInputData(after);
  const Image kept = moved.view(Mapper::VIEW_BOUNDARY_FACES);
  const Image keptPlaces = moved.view(Mapper::VIEW_BOUNDARY_COORDINATES);
  BoundaryScene fresh(after);
  const Image anew = fresh.view(Mapper::VIEW_BOUNDARY_FACES);
  const Image anewPlaces = fresh.view(Mapper::VIEW_BOUNDARY_COORDINATES);
  const std::size_t pixels = anew.Rgba.size() / 4;
  EXPECT_GT(10 * compare(kept, anew).Over, pixels); // other colours
  EXPECT_GT(10 * compare(keptPlaces, anewPlaces).Over, pixels);
  EXPECT_LE(100 * countOtherFaces(kept, anew), pixels); // of the same faces
  EXPECT_LE(100 * compare(withSortedColors(keptPlaces), withSortedColors(anewPlaces)).Over, pixels);
  // Other faces are found.
  EXPECT_GT(
    10 * countOtherFaces(kept, BoundaryScene(grid).view(Mapper::VIEW_BOUNDARY_FACES)), pixels);
  EXPECT_GT(10 * countOtherFaces(kept, Image(kept.Width, kept.Height)), pixels);
  EXPECT_GT(10 * countOtherFaces(Image(kept.Width, kept.Height), kept), pixels);
}

// No ray is marched, neither for the picture nor for statistics.
TEST(BoundaryView, NothingIsMarched)
{
  BoundaryScene scene(boundaryLattice());
  scene.Mapper->CollectDiagnosticsOn();
  const Image view = scene.view(Mapper::VIEW_BOUNDARY_FACES);
  const vtkTypeInt64 bytes = scene.Mapper->GetGPUMemoryBytes();
  vtkTetMarchFrameStatistics* statistics = scene.Mapper->GetLastFrameStatistics();
  EXPECT_EQ(scene.Mapper->GetNumberOfRays(), 0);
  EXPECT_EQ(statistics->GetNumberOfPixels(vtkTetMarchFrameStatistics::CELLS), 0);
  EXPECT_GT(statistics->GetSeconds(), 0.0);
  EXPECT_GT(scene.Mapper->GetNumberOfDraws(), 0);
  scene.view(Mapper::VIEW_CELLS);
  EXPECT_GT(scene.Mapper->GetNumberOfRays(), 0);
  EXPECT_GT(scene.Mapper->GetGPUMemoryBytes(), bytes);
  EXPECT_EQ(scene.view(Mapper::VIEW_BOUNDARY_FACES).Rgba, view.Rgba);
  EXPECT_EQ(scene.Mapper->GetNumberOfRays(), 0);
  EXPECT_EQ(scene.Mapper->GetGPUMemoryBytes(), bytes);
}

TEST(BoundaryView, TellsNothingOfAPicturesTime)
{
  BoundaryScene scene(boundaryLattice());
  scene.Mapper->SetFrameTimeBudget(100.0);
  const auto tolerances = [&scene](int mode)
  {
    std::set<double> used;
    for (int i = 0; i < 12; ++i)
    {
      scene.view(mode);
      used.insert(scene.Mapper->GetUsedErrorTolerance());
    }
    return used;
  };
  EXPECT_EQ(tolerances(Mapper::VIEW_BOUNDARY_FACES).size(), 1u);
  EXPECT_GT(tolerances(Mapper::VIEW_PICTURE).size(), 1u); // better levels are tried
}

TEST(BoundaryView, TilesAreTheFrame)
{
  for (const double nearPlane : { 0.5, 2.4 })
  {
    BoundaryScene scene(latticeWithHole(6));
    scene.camera()->SetClippingRange(nearPlane, 10.0);
    scene.Mapper->SetMaxDrawTimeInSeconds(0.0);
    const Image view = scene.view(Mapper::VIEW_BOUNDARY_COORDINATES);
    EXPECT_EQ(scene.Mapper->GetNumberOfDraws(), 1);
    scene.Mapper->SetMaxDrawTimeInSeconds(1e-9);
    EXPECT_EQ(scene.view(Mapper::VIEW_BOUNDARY_COORDINATES).Rgba, view.Rgba);
    EXPECT_GT(scene.Mapper->GetNumberOfDraws(), 10);
  }
}
} // namespace
