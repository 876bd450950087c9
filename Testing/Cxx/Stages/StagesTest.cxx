// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Only the stages whose input changed are done again, and what they make then is right.
#include "StageScene.h"

#include "vtkActor.h"

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace
{
using namespace tetmarch::testing;
using Stages = StageScene;

TEST_F(Stages, TheFirstFrameDoesAll)
{
  const Work work = workOf(this->Shown.Mapper);
  EXPECT_EQ(work.Mesh, 1);
  EXPECT_EQ(work.Scalars, 1);
  EXPECT_EQ(work.Tables, 1);
  EXPECT_EQ(this->Shown.Mapper->GetNumberOfTetrahedra(), 6 * 8 * 8 * 8);
  EXPECT_EQ(this->Shown.Mapper->GetNumberOfBoundaryFaces(), 6 * 2 * 8 * 8);
  EXPECT_GT(work.Bytes, this->bytesOfTetrahedra());
  EXPECT_GE(this->Shown.Mapper->GetGPUMemoryBytes(), work.Bytes);
  EXPECT_GT(this->Shown.Mapper->GetTimeToDraw(), 0.0);
}

TEST_F(Stages, NothingChangesNothing)
{
  this->expectRuns(0, 0, 0);
  EXPECT_EQ(this->Changed, 0.0);
}

TEST_F(Stages, CameraMovesUploadNothing)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Shown.camera()->Azimuth(20.0);
    this->Shown.camera()->Dolly(1.05);
    this->Shown.camera()->SetParallelProjection(i == 2);
    this->expectRuns(0, 0, 0);
    EXPECT_GT(this->Changed, 0.1);
  }
}

TEST_F(Stages, VolumeMovesUploadNothing)
{
  this->Shown.Volume->RotateY(30.0);
  this->Shown.Volume->SetScale(0.9, -0.8, 1.0);
  this->expectRuns(0, 0, 0);
  EXPECT_GT(this->Changed, 0.1);
}

TEST_F(Stages, TheFirstCutOfTheNearPlaneAddsTheHierarchyOnce)
{
  this->Shown.camera()->SetClippingRange(2.8, 10.0);
  const vtkTypeInt64 before = this->Shown.Mapper->GetUploadedBytes();
  this->Shown.render();
  EXPECT_GT(this->Shown.Mapper->GetUploadedBytes(), before);
  this->Shown.camera()->Azimuth(5.0);
  this->expectRuns(0, 0, 0);
  this->Shown.camera()->SetClippingRange(0.5, 10.0);
  this->expectRuns(0, 0, 0);
}

TEST_F(Stages, UnitDistanceRebuildsNothing)
{
  this->Shown.property()->SetScalarOpacityUnitDistance(1.0);
  this->expectRuns(0, 0, 0);
  EXPECT_GT(this->Changed, 0.1);
}

TEST_F(Stages, OpacityEditsRebuildTables)
{
  this->Shown.property()->GetScalarOpacity()->AddPoint(0.8, 0.0);
  this->expectRuns(0, 0, 1);
  EXPECT_GT(this->Changed, 0.05);
  EXPECT_LT(this->Done.Bytes, 1024 * 1024);
}

TEST_F(Stages, ColourEditsRebuildTables)
{
  this->Shown.property()->GetRGBTransferFunction()->AddRGBPoint(0.3, 1.0, 0.0, 1.0);
  this->expectRuns(0, 0, 1);
  EXPECT_GT(this->Changed, 0.05);
}

TEST_F(Stages, NewFunctionsRebuildTables)
{
  setSpikyFunctions(this->Shown.property());
  this->expectRuns(0, 0, 1);
  EXPECT_GT(this->Changed, 0.05);
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(0.0, 1.0);
  this->Shown.property()->SetColor(gray);
  this->expectRuns(0, 0, 1);
  EXPECT_GT(this->Changed, 0.05);
}

TEST_F(Stages, ANewPropertyRebuildsTables)
{
  vtkNew<vtkVolumeProperty> property;
  setPlainFunctions(property, { 0.2, 0.9, 0.4 }, 0.5);
  this->Shown.Volume->SetProperty(property);
  this->expectRuns(0, 0, 1);
  EXPECT_GT(this->Changed, 0.05);
}

TEST_F(Stages, OpacityLawRebuildsTables)
{
  this->Shown.Mapper->SetOpacityLawToStructured();
  this->expectRuns(0, 0, 1);
  EXPECT_GT(this->Changed, 0.02);
  this->Shown.Mapper->SetOpacityLawToUnstructured();
  this->expectRuns(0, 0, 1);
}

TEST_F(Stages, OpacityLawIsAlphaOverDistanceOrItsLogarithm)
{
  // Through the middle of a cube that fills the view the chord is 1.
  setPlainFunctions(this->Shown.property(), { 1.0, 1.0, 1.0 }, 0.6);
  this->Shown.property()->SetScalarOpacityUnitDistance(1.0);
  this->Shown.camera()->ParallelProjectionOn();
  this->Shown.camera()->SetParallelScale(0.4);
  this->Shown.camera()->SetPosition(0.5, 0.5, 3.0);
  this->Shown.camera()->SetFocalPoint(0.5, 0.5, 0.5);
  this->Shown.camera()->SetViewUp(0.0, 1.0, 0.0);
  EXPECT_NEAR(this->Shown.render().pixel(48, 48)[3], 1.0 - std::exp(-0.6), 2e-5);
  this->Shown.Mapper->SetOpacityLawToStructured();
  EXPECT_NEAR(this->Shown.render().pixel(48, 48)[3], 0.6, 2e-5);
}

TEST_F(Stages, MovedPointsRebuildTheMesh)
{
  vtkPoints* points = this->Shown.Data->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    points->SetPoint(i, p[0], 0.7 * p[1], p[2]);
  }
  points->Modified();
  this->expectRuns(1, 1, 0);
  EXPECT_GT(this->Changed, 0.1);
}

TEST_F(Stages, AnotherDatasetAndBack)
{
  const Grid first = this->Shown.Data;
  const Image firstPicture = this->Before;
  this->Shown.Data = latticeWithHole(6, 0.15, 1, sineField());
  this->Shown.Mapper->SetInputData(this->Shown.Data);
  this->expectRuns(1, 1, 1);
  EXPECT_GT(this->Changed, 0.05);
  this->Shown.Data = first;
  this->Shown.Mapper->SetInputData(first);
  this->expectRuns(1, 1, 1);
  EXPECT_EQ(compare(this->Before, firstPicture).Max, 0.0);
}

TEST_F(Stages, DepthsAreCopiedOnlyForOpaqueGeometry)
{
  const vtkTypeInt64 bytes = this->Shown.Mapper->GetGPUMemoryBytes();
  const auto ball = makeBall({ 0.5, 0.5, 0.5 }, 0.2, { 1.0, 1.0, 1.0 });
  ball->VisibilityOff();
  this->Shown.Renderer->AddActor(ball);
  this->Shown.render();
  EXPECT_EQ(this->Shown.Mapper->GetGPUMemoryBytes(), bytes);
  ball->VisibilityOn();
  this->Shown.render();
  EXPECT_GE(this->Shown.Mapper->GetGPUMemoryBytes(), bytes + 4 * 96 * 96);
}

TEST_F(Stages, DiagnosticsOnlyWhenOn)
{
  EXPECT_GT(this->Shown.Mapper->GetNumberOfRays(), 0);
  this->Shown.Mapper->CollectDiagnosticsOff();
  this->Shown.Window->Render();
  EXPECT_EQ(this->Shown.Mapper->GetNumberOfRays(), 0);
  EXPECT_THROW(floatPictureOf(this->Shown.Mapper, 96, 96), std::runtime_error);
}
} // namespace
