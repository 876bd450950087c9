// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which array is drawn, by vtkAbstractMapper's rules, and what scalars of every kind look like.
#include "CpuReference.h"
#include "ErrorWatch.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkShortArray.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 80;

Grid lattice() { return jitteredLattice(5, 0.15, 1, sineField()); }

// Point arrays f and g, cell arrays c and d; f and c are active.
Grid latticeOfFourArrays()
{
  const Grid grid = lattice();
  const Grid other = jitteredLattice(5, 0.15, 1, radialField());
  other->GetPointData()->GetArray("f")->SetName("g");
  other->GetCellData()->GetArray("c")->SetName("d");
  grid->GetPointData()->AddArray(other->GetPointData()->GetArray("g"));
  grid->GetCellData()->AddArray(other->GetCellData()->GetArray("d"));
  return grid;
}

// The picture of one array alone.
Image pictureOf(vtkDataArray* array, bool ofCells)
{
  const Grid grid = lattice();
  grid->GetPointData()->Initialize();
  grid->GetCellData()->Initialize();
  vtkDataSetAttributes* data = grid->GetPointData();
  if (ofCells)
  {
    data = grid->GetCellData();
  }
  data->SetScalars(array);
  return Scene(grid, Side, Side).render();
}

TEST(ArraySelection, ByNameNumberAndAttribute)
{
  const Grid grid = latticeOfFourArrays();
  const auto alone = [&](const char* name)
  {
    vtkDataArray* ofPoints = grid->GetPointData()->GetArray(name);
    return pictureOf(ofPoints ? ofPoints : grid->GetCellData()->GetArray(name), !ofPoints);
  };
  Scene scene(grid, Side, Side);
  auto* mapper = scene.Mapper.Get();
  const auto expectDrawn = [&](const char* name)
  {
    const Image picture = scene.render();
    for (const char* each : { "f", "g", "c", "d" })
    {
      const double difference = compare(picture, alone(each)).Max;
      EXPECT_EQ(difference < 0.02, each == std::string(name)) << name << ": " << each;
      EXPECT_TRUE(difference == 0.0 || difference > 0.02);
    }
  };

  expectDrawn("f");
  mapper->SetScalarModeToUseCellData();
  expectDrawn("c");
  mapper->SetScalarModeToUsePointData();
  expectDrawn("f");
  grid->GetPointData()->SetActiveScalars("g");
  expectDrawn("g");
  grid->GetPointData()->SetActiveScalars("f");

  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray("g");
  expectDrawn("g");
  mapper->SelectScalarArray(0);
  expectDrawn("f");
  mapper->SelectScalarArray(1);
  expectDrawn("g");
  mapper->SetScalarModeToUseCellFieldData();
  expectDrawn("d");
  mapper->SelectScalarArray(0);
  expectDrawn("c");
  mapper->SelectScalarArray("d");
  expectDrawn("d");
  mapper->SelectScalarArray("c");
  expectDrawn("c");

  // Without active point scalars the default are those of cells.
  mapper->SetScalarModeToDefault();
  grid->GetPointData()->SetActiveScalars(nullptr);
  expectDrawn("c");
}

TEST(ScalarKinds, TheFirstOfSeveralComponents)
{
  const Grid grid = lattice();
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(scalars->GetNumberOfTuples());
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    vectors->SetTuple3(i, scalars->GetTuple1(i), 0.1 * double(i % 10), 1e9);
  }
  EXPECT_EQ(compare(pictureOf(vectors, false), pictureOf(scalars, false)).Max, 0.0);
}

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

  Scene Shown{ lattice(), Side, Side };
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

TEST_P(Vectors, AComponentThatIsNotThereIsAnErrorOnce)
{
  const Image first = this->pictureOf("velocity");
  const ErrorWatch watch(this->Shown.Mapper);
  this->Shown.Mapper->SetVectorModeToComponent();
  this->Shown.Mapper->SetVectorComponent(3);
  this->Shown.Window->Render();
  this->Shown.Window->Render();
  ASSERT_EQ(watch.Errors.size(), 1u);
  EXPECT_NE(watch.Errors[0].find("\"velocity\" has no component 3"), std::string::npos)
    << watch.Errors[0];
  this->Shown.Mapper->SetVectorComponent(0);
  EXPECT_EQ(compare(this->Shown.render(), first).Max, 0.0);
  EXPECT_EQ(watch.Errors.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(ScalarKinds, Vectors, testing::Bool(),
  [](const auto& of) { return of.param ? "OfCells" : "OfPoints"; });

TEST(ScalarKinds, Integers)
{
  const Grid grid = lattice();
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  vtkNew<vtkShortArray> integers;
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    integers->InsertNextValue(static_cast<short>(std::lround(scalars->GetTuple1(i))));
  }
  grid->GetPointData()->SetScalars(integers);
  Scene scene(grid, Side, Side);
  expectParity(scene);
}

TEST(ScalarKinds, Constant)
{
  // Through the middle of the cube the chord is 1.
  for (const bool ofCells : { false, true })
  {
    Scene scene(jitteredLattice(5, 0.15, 1, constantField(0.7)), Side, Side);
    scene.Mapper->SetScalarMode(
      ofCells ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA);
    scene.property()->SetScalarOpacityUnitDistance(1.0);
    scene.camera()->ParallelProjectionOn();
    scene.camera()->SetParallelScale(0.4);
    scene.camera()->SetPosition(0.5, 0.5, 3.0);
    scene.camera()->SetFocalPoint(0.5, 0.5, 0.5);
    scene.camera()->SetViewUp(0.0, 1.0, 0.0);
    const double alpha = 1.0 - std::exp(-scene.property()->GetScalarOpacity()->GetValue(0.7));
    const Image picture = scene.render();
    for (std::size_t i = 3; i < picture.Rgba.size(); i += 4)
    {
      ASSERT_NEAR(picture.Rgba[i], alpha, 2e-5);
    }
  }
}

TEST(ScalarKinds, HugeRanges)
{
  const Grid grid = lattice();
  vtkDataArray* scalars = grid->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetTuple1(i, i % 5 ? scalars->GetTuple1(i) : (i % 2 ? 1e300 : -1e300));
  }
  Scene scene(grid, Side, Side);
  expectParity(scene);
  for (const float value : scene.render().Rgba)
  {
    ASSERT_GE(value, 0.0f); // so no NaN either
    ASSERT_LE(value, 1.0f);
  }
}

// The same without the cells that a value that is not finite touches.
void expectHoles(const Grid& grid, bool ofCells)
{
  const Grid rest = Grid::New();
  rest->SetPoints(grid->GetPoints());
  rest->Allocate(grid->GetNumberOfCells());
  vtkDataArray* values =
    ofCells ? grid->GetCellData()->GetScalars() : grid->GetPointData()->GetScalars();
  vtkNew<vtkDoubleArray> kept;
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, points);
    bool finite = !ofCells || std::isfinite(values->GetTuple1(cell));
    for (vtkIdType i = 0; !ofCells && i < 4; ++i)
    {
      finite = finite && std::isfinite(values->GetTuple1(points->GetId(i)));
    }
    if (finite)
    {
      rest->InsertNextCell(VTK_TETRA, points);
      kept->InsertNextValue(ofCells ? values->GetTuple1(cell) : 0.0);
    }
  }
  EXPECT_LT(rest->GetNumberOfCells(), grid->GetNumberOfCells());
  if (ofCells)
  {
    rest->GetCellData()->SetScalars(kept);
  }
  else
  {
    rest->GetPointData()->SetScalars(values);
  }
  const auto mode = ofCells ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA;
  Scene whole(grid, Side, Side);
  Scene holes(rest, Side, Side);
  whole.Mapper->SetScalarMode(mode);
  holes.Mapper->SetScalarMode(mode);
  const ErrorWatch watch(whole.Mapper);
  const Difference difference = compare(whole.render(), holes.render());
  EXPECT_LE(difference.Max, 2.0 / 255.0) << difference.text();
  EXPECT_LE(difference.Rms, 0.3 / 255.0) << difference.text();
  EXPECT_TRUE(watch.Errors.empty());
  EXPECT_GT(compare(whole.render(), Scene(lattice(), Side, Side).render()).Max, 0.1);
  std::cout << "[ MEASURED ] " << difference.text() << '\n';
}

TEST(ScalarKinds, NotFiniteOnesLeaveHoles)
{
  const Grid cells = lattice();
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); i += 7)
  {
    cells->GetCellData()->GetScalars()->SetTuple1(i, std::numeric_limits<double>::infinity());
  }
  expectHoles(cells, true);
  const Grid points = lattice();
  for (vtkIdType i = 5; i < points->GetNumberOfPoints(); i += 23)
  {
    points->GetPointData()->GetScalars()->SetTuple1(
      i, i % 2 ? -std::numeric_limits<double>::infinity() : std::nan(""));
  }
  expectHoles(points, false);
}
} // namespace
