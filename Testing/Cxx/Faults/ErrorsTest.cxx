// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What can't be drawn is reported once, with what is wrong and what helps, and leaves no trace when
// it is put right.
#include "ErrorScene.h"
#include "OtherGrid.h"
#include "Scene.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkPointData.h"

#include <chrono>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <thread>

namespace
{
using namespace tetmarch::testing;

const double NotANumber = std::numeric_limits<double>::quiet_NaN();

Grid lattice() { return ErrorScene::soundGrid(); }

class Errors : public ErrorScene
{
};

TEST_F(Errors, NoScalars)
{
  const Grid grid = lattice();
  grid->GetPointData()->SetActiveScalars(nullptr);
  grid->GetCellData()->SetActiveScalars(nullptr);
  this->expectErrorOf(
    grid, { "no active scalars", "Point arrays: f", "cell arrays: c", "SelectScalarArray" });
}

TEST_F(Errors, NoArraysAtAll)
{
  const Grid grid = lattice();
  grid->GetPointData()->Initialize();
  grid->GetCellData()->Initialize();
  this->expectErrorOf(grid, { "Point arrays: none", "cell arrays: none" });
}

TEST_F(Errors, ArrayThatIsNotThere)
{
  this->expectErrorOfArray(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, "temperature",
    { "\"temperature\"", "in the point data", "f" });
  this->expectErrorOfArray(
    VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, "f", { "\"f\"", "in the cell data", "c" });
  this->expectErrorOfArray(
    VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, 7, { "number 7", "in the cell data" });
}

TEST_F(Errors, FieldData)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("field");
  array->InsertNextValue(1.0);
  this->Shown.Data->GetFieldData()->AddArray(array);
  this->expectErrorOfArray(
    VTK_SCALAR_MODE_USE_FIELD_DATA, "field", { "Field data", "point or cell data" });
}

TEST_F(Errors, ArrayOfWrongLength)
{
  const Grid grid = lattice();
  vtkNew<vtkDoubleArray> few;
  few->SetName("few");
  few->SetNumberOfTuples(5);
  grid->GetPointData()->SetScalars(few);
  this->expectErrorOf(grid, { "\"few\"", "5 tuples", "125 points" });
  grid->GetPointData()->Initialize();
  grid->GetCellData()->SetScalars(few);
  this->expectErrorOf(grid, { "\"few\"", "5 tuples", "384 cells" });
}

TEST_F(Errors, PointIdsOutOfRange)
{
  const Grid grid = lattice();
  const vtkIdType corners[4] = { 0, 1, 2, 4711 };
  grid->InsertNextCell(VTK_TETRA, 4, corners);
  grid->GetCellData()->Initialize();
  this->expectErrorOf(grid, { "cell 384", "point 4711", "125 points" });
}

TEST_F(Errors, CoordinatesThatAreNotFinite)
{
  for (const double bad : { NotANumber, std::numeric_limits<double>::infinity() })
  {
    const Grid grid = lattice();
    grid->GetPoints()->SetPoint(33, 0.5, bad, 0.5);
    this->expectErrorOf(grid, { "point 33", "not a finite number" });
  }
}

TEST_F(Errors, AnotherKindOfGrid)
{
  vtkNew<OtherGrid> grid;
  this->expectErrorOf(grid, { "OtherGrid", "vtkUnstructuredGrid" });
}

TEST_F(Errors, UnitDistance)
{
  for (const double bad : { 0.0, -1.0, NotANumber })
  {
    this->expectError([=] { this->Shown.property()->SetScalarOpacityUnitDistance(bad); },
      [this] { this->Shown.property()->SetScalarOpacityUnitDistance(0.25); },
      { "unit distance", "above 0" });
  }
}

TEST_F(Errors, SingularMatrix)
{
  this->expectError([this] { this->Shown.Volume->SetScale(1.0, 0.0, 1.0); },
    [this] { this->Shown.Volume->SetScale(1.0); }, { "matrix of the volume", "singular" });
}

TEST_F(Errors, ErrorsOfOthersInTheGLAreNotOurs)
{
  this->Shown.Renderer->AddActor(makeBall({ 0.5, 0.45, 0.6 }, 0.35, { 1.0, 0.8, 0.2 }));
  const Image expected = this->frame();
  const ErrorWatch watch(this->Shown.Mapper);
  this->Shown.Window->SetSize(Side + 1, Side); // so that textures are made anew
  this->frame();
  this->Shown.Window->SetSize(Side, Side);
  glEnable(GL_TEXTURE_BUFFER); // no capability: a GL error
  EXPECT_EQ(compare(this->frame(), expected).Max, 0.0);
  EXPECT_EQ(watch.Errors, std::vector<std::string>());
}

TEST_F(Errors, NothingToDrawIsNoError)
{
  this->show(emptyGrid());
  this->expectEmptyWithoutErrors();
  this->show(triangleAndLineGrid());
  this->expectEmptyWithoutErrors();
  vtkNew<vtkUnstructuredGrid> bare;
  this->show(bare);
  this->expectEmptyWithoutErrors();
  this->showSound();
  this->expectSound();
}

TEST_F(Errors, TransparentFunctionsDrawNothing)
{
  vtkNew<vtkVolumeProperty> clear;
  setPlainFunctions(clear, { 1.0, 1.0, 1.0 }, 0.0);
  vtkVolumeProperty* opaque = this->Shown.property();
  opaque->Register(nullptr);
  this->Shown.Volume->SetProperty(clear);
  this->expectNothingVisible();
  this->Shown.Volume->SetProperty(opaque);
  opaque->UnRegister(nullptr);
  this->expectSound();
}

TEST_F(Errors, AllScalarsNaNDrawNothing)
{
  for (const bool ofCells : { false, true })
  {
    const Grid grid = lattice();
    vtkDataArray* array =
      ofCells ? grid->GetCellData()->GetScalars() : grid->GetPointData()->GetScalars();
    array->Fill(NotANumber);
    this->Shown.Mapper->SetScalarMode(
      ofCells ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA);
    this->showSound();
    this->frame(); // the array is not finite once more
    this->show(grid);
    this->expectNothingVisible();
  }
}

TEST_F(Errors, DefaultPropertyIsNoError)
{
  this->Shown.Volume->SetProperty(nullptr);
  const ErrorWatch watch(this->Shown.Mapper);
  this->frame();
  EXPECT_EQ(watch.Errors, std::vector<std::string>());
}

TEST_F(Errors, AbortedBuildDrawsNothingAndIsMadeUpFor)
{
  const Grid grid = withCells32(lattice()); // another grid that looks the same
  this->show(grid);
  const ErrorWatch watch(this->Shown.Mapper);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetClientData(this->Shown.Window);
  abort->SetCallback([](vtkObject*, unsigned long, void* window, void*)
    { static_cast<vtkRenderWindow*>(window)->SetAbortRender(1); });
  const unsigned long tag = this->Shown.Window->AddObserver(vtkCommand::AbortCheckEvent, abort);
  // Windows ask at most five times a second.
  std::this_thread::sleep_for(std::chrono::milliseconds(250));
  const vtkTypeInt64 bytes = this->Shown.Mapper->GetUploadedBytes();
  this->Shown.Window->Render();
  EXPECT_EQ(this->Shown.Mapper->GetUploadedBytes(), bytes);
  EXPECT_EQ(this->Shown.Mapper->GetNumberOfTetrahedra(), 0);
  EXPECT_EQ(compare(this->Shown.frame(), this->Empty).Max, 0.0);
  this->Shown.Window->RemoveObserver(tag);
  this->expectSound();
  EXPECT_EQ(watch.Errors, std::vector<std::string>());
}
} // namespace
