// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures of scalars of every kind: integers, constants, huge ranges, and values that are not
// finite.
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
#include <iostream>
#include <limits>

namespace
{
using namespace tetmarch::testing;

constexpr int Side = 80;

Grid lattice() { return jitteredLattice(5, 0.15, 1, sineField()); }

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

// The picture is that of the grid without the cells that touch a value that is not finite.
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
