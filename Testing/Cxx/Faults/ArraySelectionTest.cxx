// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which array of a grid is drawn: that of vtkAbstractMapper's rules, and its first component.
#include "Scene.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <string>

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
} // namespace
