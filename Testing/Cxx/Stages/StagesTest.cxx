// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Only the stages whose input changed are done again, and what they make then is right.
#include "CpuReference.h"

#include "vtkActor.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

// The counters of the stages, to say by how much they grew.
struct Work
{
  vtkTypeInt64 Mesh = 0;
  vtkTypeInt64 Scalars = 0;
  vtkTypeInt64 Tables = 0;
  vtkTypeInt64 Bytes = 0;
};

Work workOf(const vtkTetMarchVolumeMapper* mapper)
{
  return { mapper->GetMeshBuilds(), mapper->GetScalarsBuilds(), mapper->GetTablesBuilds(),
    mapper->GetUploadedBytes() };
}

class Stages : public testing::Test
{
protected:
  Stages() { this->Before = this->Shown.render(); }

  // Renders, expects those stages to have run once and the others not, and the picture to be what
  // the reference makes of the scene as it is now.
  void expectRuns(int mesh, int scalars, int tables)
  {
    const Work before = workOf(this->Shown.Mapper);
    const Image after = this->Shown.render();
    this->Done = workOf(this->Shown.Mapper);
    EXPECT_EQ(this->Done.Mesh - before.Mesh, mesh);
    EXPECT_EQ(this->Done.Scalars - before.Scalars, scalars);
    EXPECT_EQ(this->Done.Tables - before.Tables, tables);
    this->Done.Bytes -= before.Bytes;
    EXPECT_EQ(this->Done.Bytes > 0, mesh + scalars + tables > 0);
    this->Changed = compare(this->Before, after).Max;
    this->Before = after;
    const Mask inside = regionsOf(this->Shown).Inside;
    EXPECT_LE(compare(after, referenceOf(this->Shown).Picture, inside).Max, 2.0 / 255.0);
  }

  vtkDataArray* scalars() { return this->Shown.Data->GetPointData()->GetScalars(); }
  vtkTypeInt64 bytesOfLinks() const
  {
    return 32 * vtkTypeInt64(this->Shown.Mapper->GetNumberOfTetrahedra());
  }

  Scene Shown{ jitteredLattice(8, 0.15, 1, sineField()), 96, 96 };
  Image Before;
  Work Done;
  double Changed = 0.0; // between the two pictures
};

TEST_F(Stages, TheFirstFrameDoesAll)
{
  const Work work = workOf(this->Shown.Mapper);
  EXPECT_EQ(work.Mesh, 1);
  EXPECT_EQ(work.Scalars, 1);
  EXPECT_EQ(work.Tables, 1);
  EXPECT_EQ(this->Shown.Mapper->GetNumberOfTetrahedra(), 6 * 8 * 8 * 8);
  EXPECT_EQ(this->Shown.Mapper->GetNumberOfBoundaryFaces(), 6 * 2 * 8 * 8);
  EXPECT_GT(work.Bytes, this->bytesOfLinks());
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

TEST_F(Stages, NewScalarsOnTheSameMeshKeepItsLinks)
{
  // Of the same range, so that the tables stay too.
  vtkNew<vtkDoubleArray> turned;
  turned->SetName("turned");
  const vtkIdType count = this->scalars()->GetNumberOfTuples();
  turned->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    turned->SetValue(i, this->scalars()->GetTuple1(count - 1 - i));
  }
  this->Shown.Data->GetPointData()->SetScalars(turned);
  this->expectRuns(0, 1, 0);
  EXPECT_GT(this->Changed, 0.05);
  EXPECT_LT(this->Done.Bytes, this->bytesOfLinks());
}

TEST_F(Stages, AnotherComponentKeepsTheMesh)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(2);
  const vtkIdType count = this->scalars()->GetNumberOfTuples();
  for (vtkIdType i = 0; i < count; ++i)
  {
    // Both components have one range.
    vectors->InsertNextTuple2(
      this->scalars()->GetTuple1(i), this->scalars()->GetTuple1(count - 1 - i));
  }
  this->Shown.Data->GetPointData()->SetScalars(vectors);
  this->expectRuns(0, 1, 0);
  EXPECT_EQ(this->Changed, 0.0);
  this->Shown.Mapper->SetVectorModeToComponent();
  this->expectRuns(0, 0, 0);
  this->Shown.Mapper->SetVectorComponent(1);
  this->expectRuns(0, 1, 0);
  EXPECT_GT(this->Changed, 0.05);
  EXPECT_LT(this->Done.Bytes, this->bytesOfLinks());
  this->Shown.Mapper->SetVectorModeToMagnitude();
  this->expectRuns(0, 1, 1);
  EXPECT_GT(this->Changed, 0.05);
  // The colour function decides; its other edits are no business of scalars.
  this->Shown.Mapper->SetVectorModeToDisabled();
  this->expectRuns(0, 1, 1);
  vtkColorTransferFunction* colors = this->Shown.property()->GetRGBTransferFunction();
  colors->AddRGBPoint(0.3, 1.0, 0.0, 1.0);
  this->expectRuns(0, 0, 1);
  colors->SetVectorComponent(1);
  this->expectRuns(0, 1, 1);
  colors->SetVectorModeToMagnitude();
  this->expectRuns(0, 1, 1);
}

TEST_F(Stages, AnArrayModifiedInPlace)
{
  for (vtkIdType i = 0; i < this->scalars()->GetNumberOfTuples(); ++i)
  {
    this->scalars()->SetTuple1(i, 0.3 + 0.5 * this->scalars()->GetTuple1(i));
  }
  EXPECT_EQ(compare(this->Shown.render(), this->Before).Max, 0.0); // nobody said so
  this->scalars()->Modified();
  this->expectRuns(0, 1, 1); // another range, so the tables as well
  EXPECT_GT(this->Changed, 0.05);
  EXPECT_LT(this->Done.Bytes, this->bytesOfLinks());
}

TEST_F(Stages, CellScalarsAndBack)
{
  this->Shown.drawCellScalars();
  this->expectRuns(0, 1, 1);
  EXPECT_GT(this->Changed, 0.01);
  this->Shown.Mapper->SetScalarModeToDefault();
  this->expectRuns(0, 1, 1);
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
