// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cell grids of VTK 9.5 and later look like the unstructured grids with the same cells.
#include "CellGrids.h"
#include "ErrorScene.h"
#include "GridTransforms.h"
#include "LatticeGrids.h"
#include "QuadraticGrids.h"

#include "vtkBoundingBox.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <iostream>

namespace
{
using namespace tetmarch::testing;

constexpr double Jump = 0.3;
constexpr double Bend = 0.1;
constexpr double CurvedTolerance = 0.01;

double wave(double x, double y, double z) { return 0.5 + 0.4 * (x - y) * (z + y); }

struct CellGridCase
{
  const char* Name;
  const char* Type;
  FunctionsOfCells Functions;
  Grid (*Make)();
};

void PrintTo(const CellGridCase& of, std::ostream* os) { *os << of.Name; }

class CellGrids : public ::testing::TestWithParam<CellGridCase>
{
};

// Alone or as a block, before and after a change of values.
TEST_P(CellGrids, LookLikeTheirCells)
{
  const Grid grid = GetParam().Make();
  const auto cells = cellGridOf(grid, GetParam().Type, GetParam().Functions);
  vtkNew<vtkPartitionedDataSet> part;
  part->SetPartition(0, cells);
  vtkNew<vtkPartitionedDataSetCollection> inBlocks;
  inBlocks->SetPartitionedDataSet(0, part);
  for (vtkDataObject* input : std::initializer_list<vtkDataObject*>{ cells, inBlocks })
  {
    SCOPED_TRACE(input->GetClassName());
    Scene scene(grid);
    Scene wanted(grid);
    scene.Mapper->SetInputDataObject(input);
    for (int round = 0; round < 2; ++round)
    {
      // To VTK's mappers, and to ParaView, fields of cell grids are of cells.
      scene.Mapper->SelectScalarArray("f");
      scene.Mapper->SetScalarMode(
        round == 0 ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
      scene.Mapper->SetGeometryTolerance(CurvedTolerance);
      wanted.Mapper->SetGeometryTolerance(CurvedTolerance);
      const Difference difference = compare(scene.render(), wanted.render());
      EXPECT_LE(difference.Max, 1e-5) << difference.text();
      EXPECT_EQ(scene.Mapper->GetNumberOfTetrahedra(), wanted.Mapper->GetNumberOfTetrahedra());
      EXPECT_EQ(vtkBoundingBox(scene.Mapper->GetBounds()), vtkBoundingBox(grid->GetBounds()));
      std::cout << "[ MEASURED ] " << difference.text() << "\n";
      for (vtkDataArray* values :
        { grid->GetPointData()->GetScalars(),
          vtkDataArray::SafeDownCast(cells->GetCellAttributeByName("f")->GetArrayForCellTypeAndRole(
            GetParam().Type, "values"_token)) })
      {
        for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
        {
          for (int c = 0; c < values->GetNumberOfComponents(); ++c)
          {
            values->SetComponent(i, c, 1 - values->GetComponent(i, c));
          }
        }
        values->Modified();
      }
      grid->Modified();
    }
    EXPECT_EQ(scene.Mapper->GetNumberOfLostRays(), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, CellGrids,
  ::testing::Values(CellGridCase{ "LinearTetrahedra", "vtkDGTet", { "HGRAD", "C", 1, true },
                      [] { return jitteredLattice(3, 0.2, 1, wave); } },
    CellGridCase{ "LinearTetrahedraWithJumps", "vtkDGTet", { "HGRAD", "C", 1, false },
      [] { return withJumps(jitteredLattice(3, 0.2, 1, wave), Jump); } },
    CellGridCase{ "QuadraticTetrahedra", "vtkDGTet", { "HGRAD", "C", 2, true },
      [] { return quadraticTetLattice(2, Bend, wave); } },
    CellGridCase{ "QuadraticHexahedraWithJumps", "vtkDGHex", { "HGRAD", "C", 2, false },
      [] { return withJumps(triQuadraticHexLattice(2, Bend, wave), Jump); } }),
  [](const auto& tested) { return tested.param.Name; });

using CellGridErrors = ErrorScene;

TEST_F(CellGridErrors, OfGridsThatAreNotSound)
{
  const auto whole = [] { return cellGridOf(jitteredLattice(2, 0, 1), "vtkDGTet", {}); };
  const auto attributesOf = [](vtkCellGrid* grid)
  {
    return std::array<vtkCellAttribute*, 2>{ grid->GetShapeAttribute(),
      grid->GetCellAttributeByName("f") };
  };
  const auto valuesOf = [&](vtkCellGrid* grid, int attribute)
  {
    return vtkDataArray::SafeDownCast(attributesOf(grid)[attribute]->GetArrayForCellTypeAndRole(
      vtkStringToken("vtkDGTet"), "values"_token));
  };
  const std::pair<std::function<void(vtkCellGrid*)>, Words> cases[] = {
    { [&](vtkCellGrid* grid) { valuesOf(grid, 0)->SetNumberOfTuples(3); },
      { "\"shape\"", "3 values", "names number" } },
    { [&](vtkCellGrid* grid) { valuesOf(grid, 1)->SetNumberOfTuples(3); },
      { "\"f\"", "3 of 48 cells" } },
    { [&](vtkCellGrid* grid)
      { grid->GetAttributes("vtkDGTet"_token)->GetScalars()->SetComponent(5, 2, -7); },
      { "\"shape\"", "cell 5 names number -7" } },
    { [](vtkCellGrid* grid)
      {
        auto* f = grid->GetCellAttributeByName("f");
        auto info = f->GetCellTypeInfo("vtkDGTet"_token);
        info.Order = 17;
        f->SetCellTypeInfo("vtkDGTet"_token, info);
      },
      { "\"f\"", "order 17" } },
    { [](vtkCellGrid* grid)
      {
        auto* f = grid->GetCellAttributeByName("f");
        auto info = f->GetCellTypeInfo("vtkDGTet"_token);
        info.ArraysByRole.erase("values"_token);
        f->SetCellTypeInfo("vtkDGTet"_token, info);
      },
      { "\"f\"", "no values" } },
  };
  for (const auto& [spoil, words] : cases)
  {
    SCOPED_TRACE(words.back());
    const auto grid = whole();
    spoil(grid);
    this->expectError(
      [&, spoilt = grid.Get()] { this->show(spoilt); }, [this] { this->showSound(); }, words);
  }
}
} // namespace
