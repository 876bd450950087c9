// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Other scalars on the same mesh are read again, and nothing else is done again.
#include "StageScene.h"

#include "vtkDoubleArray.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;
using Stages = StageScene;

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
  EXPECT_LT(this->Done.Bytes, this->bytesOfTetrahedra());
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
  EXPECT_LT(this->Done.Bytes, this->bytesOfTetrahedra());
  this->Shown.Mapper->SetVectorModeToMagnitude();
  this->expectRuns(0, 1, 1);
  EXPECT_GT(this->Changed, 0.05);
  // The colour function says what is drawn of vectors; its other edits leave the scalars.
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
  EXPECT_EQ(compare(this->Shown.render(), this->Before).Max, 0.0); // Modified() wasn't called
  this->scalars()->Modified();
  this->expectRuns(0, 1, 1); // another range, so the tables as well
  EXPECT_GT(this->Changed, 0.05);
  EXPECT_LT(this->Done.Bytes, this->bytesOfTetrahedra());
}

TEST_F(Stages, CellScalarsAndBack)
{
  this->Shown.drawCellScalars();
  this->expectRuns(0, 1, 1);
  EXPECT_GT(this->Changed, 0.01);
  this->Shown.Mapper->SetScalarModeToDefault();
  this->expectRuns(0, 1, 1);
}
} // namespace
