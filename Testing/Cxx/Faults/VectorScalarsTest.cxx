// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The magnitude of vectors, or one of their components, as the mapper or the colour function asks.
#include "CpuReference.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 80;

// Vectors of which one component, and the magnitude, are scalars of the grid times 5.
class Vectors : public testing::TestWithParam<bool>
{
protected:
  Vectors()
  {
    vtkDataArray* scalars = this->data()->GetScalars();
    this->Scaled->SetName("scaled");
    this->Velocity->SetName("velocity");
    this->Velocity->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
    {
      const double s = scalars->GetTuple1(i);
      this->Scaled->InsertNextValue(5.0 * s);
      this->Velocity->InsertNextTuple3(4.0 * s, 5.0 * s - 1.0, -3.0 * s);
    }
    // So that the magnitude is 5 s, where the component isn't 5 s - 1.
    this->Straight->DeepCopy(this->Velocity);
    this->Straight->SetName("straight");
    this->Straight->FillComponent(1, 0.0);
    this->data()->AddArray(this->Scaled);
    this->data()->AddArray(this->Velocity);
    this->data()->AddArray(this->Straight);
    this->colors()->RemoveAllPoints();
    this->colors()->AddRGBPoint(0.0, 1.0, 0.1, 0.0);
    this->colors()->AddRGBPoint(5.0, 0.0, 0.3, 1.0);
    this->Shown.property()->GetScalarOpacity()->RemoveAllPoints();
    this->Shown.property()->GetScalarOpacity()->AddSegment(-4.0, 0.2, 5.0, 0.9);
  }
  vtkDataSetAttributes* data()
  {
    vtkUnstructuredGrid* grid = this->Shown.Data;
    return GetParam() ? static_cast<vtkDataSetAttributes*>(grid->GetCellData())
                      : static_cast<vtkDataSetAttributes*>(grid->GetPointData());
  }
  vtkColorTransferFunction* colors() { return this->Shown.property()->GetRGBTransferFunction(); }
  Image pictureOf(const char* name)
  {
    this->Shown.Mapper->SetScalarMode(
      GetParam() ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
    this->Shown.Mapper->SelectScalarArray(name);
    return this->Shown.render();
  }

  Scene Shown{ jitteredLattice(5, 0.15, 1, sineField()), Side, Side };
  vtkNew<vtkDoubleArray> Scaled;
  vtkNew<vtkDoubleArray> Velocity;
  vtkNew<vtkDoubleArray> Straight;
};

TEST_P(Vectors, MagnitudesAsAskedOfMapperOrColours)
{
  const Image scaled = this->pictureOf("scaled");
  EXPECT_GT(compare(this->pictureOf("straight"), scaled).Max, 0.05);
  this->Shown.Mapper->SetVectorModeToMagnitude();
  EXPECT_LE(compare(this->pictureOf("straight"), scaled).Max, 1e-5);
  this->Shown.Mapper->SetVectorModeToDisabled();
  this->colors()->SetVectorModeToMagnitude();
  EXPECT_LE(compare(this->pictureOf("straight"), scaled).Max, 1e-5);
  // What is not a vector is drawn as it is.
  EXPECT_EQ(compare(this->pictureOf("scaled"), scaled).Max, 0.0);
  expectParity(this->Shown);
}

TEST_P(Vectors, ComponentsAsAskedOfMapperOrColours)
{
  for (vtkIdType i = 0; i < this->Velocity->GetNumberOfTuples(); ++i)
  {
    this->Velocity->SetComponent(i, 2, this->Scaled->GetValue(i));
  }
  const Image scaled = this->pictureOf("scaled");
  EXPECT_GT(compare(this->pictureOf("velocity"), scaled).Max, 0.05);
  this->Shown.Mapper->SetVectorModeToComponent();
  this->Shown.Mapper->SetVectorComponent(1);
  EXPECT_GT(compare(this->pictureOf("velocity"), scaled).Max, 0.05);
  this->Shown.Mapper->SetVectorComponent(2);
  EXPECT_EQ(compare(this->pictureOf("velocity"), scaled).Max, 0.0);
  this->Shown.Mapper->SetVectorModeToDisabled();
  this->colors()->SetVectorComponent(2);
  EXPECT_EQ(compare(this->pictureOf("velocity"), scaled).Max, 0.0);
}

INSTANTIATE_TEST_SUITE_P(ScalarKinds, Vectors, testing::Bool(),
  [](const auto& of) { return of.param ? "OfCells" : "OfPoints"; });
} // namespace
