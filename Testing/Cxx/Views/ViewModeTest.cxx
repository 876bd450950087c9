// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The view modes: each pixel has the colour of its number.
#include "CpuReference.h"
#include "ViewScene.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using Mapper = vtkTetMarchVolumeMapper;
using Statistics = vtkTetMarchFrameStatistics;

TEST(ViewMode, ColorsAreThoseOfTheStatistics)
{
  for (const int samples : { 0, 8 })
  {
    ViewScene scene(viewLattice());
    scene.Window->SetMultiSamples(samples);
    for (const auto& [mode, quantity] : Views)
    {
      const Image frame = scene.view(mode);
      SCOPED_TRACE(scene.Mapper->GetViewModeAsString());
      expectColorsOfStatistics(scene, frame, quantity);
      const double* range = scene.table()->GetTableRange();
      const double most = scene.Mapper->GetLastFrameStatistics()->GetMaximum(quantity);
      EXPECT_LE(most, range[1]);
      EXPECT_GT(most, range[1] / (mode == Mapper::VIEW_ERROR_BOUND ? 10.0 : 2.0));
    }
  }
}

TEST(ViewMode, RangeMayBeFixed)
{
  ViewScene scene(viewLattice());
  scene.Mapper->AutomaticViewRangeOff();
  const double ranges[][2] = { { 1e-4, 2e-3 }, { 5.0, 17.5 }, { 3.0, 1000.0 } };
  for (int i = 0; i < 3; ++i)
  {
    scene.Mapper->SetViewRange(ranges[i]);
    const Image frame = scene.view(Views[i].first);
    expectColorsOfStatistics(scene, frame, Views[i].second);
    EXPECT_EQ(scene.table()->GetTableRange()[0], ranges[i][0]);
    EXPECT_EQ(scene.table()->GetTableRange()[1], ranges[i][1]);
  }
}

TEST(ViewMode, ColorsMayBeOthers)
{
  ViewScene scene(viewLattice());
  scene.view(Mapper::VIEW_CELLS);
  scene.table()->SetNumberOfTableValues(7);
  for (int i = 0; i < 7; ++i)
  {
    scene.table()->SetTableValue(i, i / 7.0, 1.0, 0.0);
  }
  const Image frame = scene.view(Mapper::VIEW_CELLS);
  expectColorsOfStatistics(scene, frame, Statistics::CELLS);
}

// The view of the error bound, pixel by pixel against the CPU reference, in a viewport off the
// corner.
TEST(ViewMode, ErrorsAreWhereTheReferenceHasThem)
{
  ViewScene scene(viewLattice(), 240, 200);
  scene.Renderer->SetViewport(0.3, 0.15, 0.95, 0.9);
  scene.Mapper->SetErrorTolerance(1.0 / 32.0);
  const Image frame = scene.view(Mapper::VIEW_ERROR_BOUND);
  const int* size = scene.Renderer->GetSize();
  const int* origin = scene.Renderer->GetOrigin();
  const std::vector<int> entries =
    entriesOf(cropped(frame, origin[0], origin[1], size[0], size[1]), scene.table());
  const ReferencePicture reference = referenceOf(scene, {}, Precision::Float);
  const Mask inside = regionsOf(scene).Inside;
  int pixels = 0;
  int off = 0;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    if (inside[i])
    {
      ++pixels;
      const auto expected =
        static_cast<int>(scene.table()->GetIndex(double(reference.ErrorBounds[i])));
      off += std::abs(entries[i] - expected) > 1;
    }
  }
  EXPECT_GT(pixels, 1000);
  EXPECT_LE(off, pixels / 50);
}

// Opaque geometry before the mesh hides it, and geometry in the mesh ends the rays.
TEST(ViewMode, OpaqueGeometryIsSeen)
{
  ViewScene scene(viewLattice());
  const auto plane = makePlane(1.3, 3.0, { 0.9, 0.1, 0.1 });
  scene.Renderer->AddActor(plane);
  scene.Volume->VisibilityOff();
  const Image hidden = scene.view(Mapper::VIEW_CELLS);
  scene.Volume->VisibilityOn();
  for (const auto& view : Views)
  {
    EXPECT_EQ(compare(scene.view(view.first), hidden).Max, 0.0);
    EXPECT_EQ(scene.Mapper->GetNumberOfRays(), 0);
  }
  scene.Renderer->RemoveActor(plane);
  scene.view(Mapper::VIEW_CELLS);
  const vtkTypeInt64 cells = scene.Mapper->GetNumberOfCrossedCells();
  scene.Renderer->AddActor(makePlane(0.5, 0.0, { 0.9, 0.1, 0.1 }));
  const Image frame = scene.view(Mapper::VIEW_CELLS);
  EXPECT_LT(scene.Mapper->GetNumberOfCrossedCells(), cells);
  EXPECT_GT(scene.Mapper->GetNumberOfCrossedCells(), 0);
  expectColorsOfStatistics(scene, frame, Statistics::CELLS);
}

TEST(ViewMode, CameraInside)
{
  ViewScene scene(latticeWithHole(6, 0.15, 1, sineField()));
  scene.camera()->SetPosition(0.05, 0.42, 0.57);
  scene.camera()->SetFocalPoint(1.0, 0.5, 0.5);
  scene.camera()->SetClippingRange(0.01, 5.0);
  for (const auto& [mode, quantity] : Views)
  {
    expectColorsOfStatistics(scene, scene.view(mode), quantity);
    EXPECT_EQ(scene.Mapper->GetNumberOfRays(), SceneSize * SceneSize);
  }
}

// Constant cells are integrated exactly, and rays through thin ones don't end early.
TEST(ViewMode, OfConstantCellsErrorsAreNone)
{
  ViewScene scene(viewLattice());
  scene.property()->SetScalarOpacityUnitDistance(10.0);
  scene.drawCellScalars();
  const Image frame = scene.view(Mapper::VIEW_ERROR_BOUND);
  EXPECT_EQ(scene.Mapper->GetLastFrameStatistics()->GetMaximum(Statistics::ERROR_BOUND), 0.0);
  const std::vector<int> entries = entriesOf(frame, scene.table());
  EXPECT_EQ(std::count(entries.begin(), entries.end(), 0), scene.Mapper->GetNumberOfRays());
}

TEST(ViewMode, OnePixel)
{
  ViewScene scene(viewLattice(), 1, 1);
  const Image frame = scene.view(Mapper::VIEW_CELLS);
  ASSERT_EQ(scene.Mapper->GetNumberOfRays(), 1);
  const auto cells = double(scene.Mapper->GetNumberOfCrossedCells());
  EXPECT_NEAR(entriesOf(frame, scene.table())[0], double(scene.table()->GetIndex(cells)), 1.0);
}
} // namespace
