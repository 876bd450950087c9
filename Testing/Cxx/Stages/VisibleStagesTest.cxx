// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What the functions show of a mesh, and where rays enter it: each is found again when it has to
// be, and where nothing is seen no ray crosses a cell.
#include "Scene.h"

#include "vtkCellData.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

struct Builds
{
  vtkTypeInt64 VisiblePart;
  vtkTypeInt64 Entries;
};

class VisibleStages : public testing::Test
{
protected:
  VisibleStages() { this->Shown.render(); }

  // Of one more frame.
  void expectBuilds(vtkTypeInt64 visiblePart, vtkTypeInt64 entries)
  {
    const vtkTetMarchVolumeMapper* mapper = this->Shown.Mapper;
    const Builds before{ mapper->GetVisiblePartBuilds(), mapper->GetEntriesBuilds() };
    this->Shown.render();
    EXPECT_EQ(mapper->GetVisiblePartBuilds() - before.VisiblePart, visiblePart);
    EXPECT_EQ(mapper->GetEntriesBuilds() - before.Entries, entries);
  }

  Scene Shown{ jitteredLattice(8, 0.15, 1, sineField()) };
};

TEST_F(VisibleStages, RunWhenTheirInputChanges)
{
  EXPECT_EQ(this->Shown.Mapper->GetVisiblePartBuilds(), 1);
  EXPECT_EQ(this->Shown.Mapper->GetEntriesBuilds(), 1);
  EXPECT_GT(this->Shown.Mapper->GetVisiblePartSeconds(), 0.0);
  EXPECT_GT(this->Shown.Mapper->GetEntriesSeconds(), 0.0);
  this->expectBuilds(0, 0);
  this->Shown.camera()->Azimuth(20.0);
  this->expectBuilds(0, 1);
  this->Shown.Window->SetSize(80, 90);
  this->expectBuilds(0, 1);
  this->Shown.property()->SetScalarOpacityUnitDistance(1.0);
  this->expectBuilds(0, 0);
  setTwoPeaks(this->Shown.property());
  this->expectBuilds(1, 0); // all of the mesh is entered, as before
}

// The functions show scalars within the range, but no cell has one of these.
TEST_F(VisibleStages, RaysCrossNothingIfNoCellIsSeen)
{
  this->Shown.drawCellScalars();
  vtkDataArray* scalars = this->Shown.Data->GetCellData()->GetArray("c");
  for (vtkIdType cell = 0; cell < scalars->GetNumberOfTuples(); ++cell)
  {
    scalars->SetTuple1(cell, cell % 2);
  }
  scalars->Modified();
  this->Shown.Data->Modified();
  const Image visible = this->Shown.render();
  const Image frame = this->Shown.frame();
  EXPECT_GT(this->Shown.Mapper->GetNumberOfCrossedCells(), 0);

  vtkPiecewiseFunction* opacity = this->Shown.property()->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(0.4, 0.0);
  opacity->AddPoint(0.5, 1.0);
  opacity->AddPoint(0.6, 0.0);
  this->Shown.render();
  EXPECT_EQ(this->Shown.Mapper->GetNumberOfRays(), 0);
  EXPECT_EQ(this->Shown.Mapper->GetNumberOfCrossedCells(), 0);
  const Image empty = this->Shown.frame();
  this->Shown.Volume->VisibilityOff();
  this->Shown.Window->Render();
  EXPECT_EQ(empty.Rgba, this->Shown.frame().Rgba);
  this->Shown.Volume->VisibilityOn();
  EXPECT_FALSE(this->Shown.Mapper->Pick(this->Shown.Renderer, this->Shown.Volume, 80, 80));

  setBumpyFunctions(this->Shown.property());
  EXPECT_EQ(this->Shown.render().Rgba, visible.Rgba);
  EXPECT_EQ(this->Shown.frame().Rgba, frame.Rgba);
}
} // namespace
