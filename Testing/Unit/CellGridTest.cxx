// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells of cell grids against VTK's own evaluation of these, and cell grids that are not sound.
#include "CellGrids.h"

#include "Input/MadeGrids.h"

#include "vtkCellData.h"
#include "vtkDGOperatorEntry.h"
#include "vtkGenericCell.h"
#include "vtkInterpolateCalculator.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVector.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>

namespace
{
using namespace tetmarch;
using namespace tetmarch::testing;
using namespace vtk::literals;

constexpr int Cells = 3;
constexpr int Ids = 40;

std::mt19937& randomly()
{
  static std::mt19937 random(1);
  return random;
}

double number() { return randomly()() / 4294967296.0; }

vtkSmartPointer<vtkDoubleArray> numbers(vtkIdType tuples, int components)
{
  auto values = vtkSmartPointer<vtkDoubleArray>::New();
  values->SetNumberOfComponents(components);
  for (vtkIdType i = 0; i < tuples * components; ++i)
  {
    values->InsertNextValue(number());
  }
  return values;
}

struct Space
{
  std::string Type;
  FunctionsOfCells Functions;
  int Count; // of functions
};

void PrintTo(const Space& space, std::ostream* os)
{
  *os << space.Type << " " << space.Functions.Basis << space.Functions.Order;
}

// The shape and the fields are whatever these numbers give.
vtkSmartPointer<vtkCellGrid> randomGrid(const Space& space, bool shared)
{
  vtkNew<vtkTypeInt64Array> cells;
  cells->SetNumberOfComponents(space.Count);
  for (int i = 0; i < Cells * space.Count; ++i)
  {
    cells->InsertNextValue(randomly()() % Ids);
  }
  const auto grid = cellGrid(space.Type, cells);
  FunctionsOfCells functions = space.Functions;
  functions.Shared = shared;
  const auto values = [&](int components)
  { return shared ? numbers(Ids, components) : numbers(Cells, components * space.Count); };
  grid->SetShapeAttribute(attribute("shape", 3, space.Type, functions, values(3)));
  grid->AddCellAttribute(attribute("f", 1, space.Type, functions, values(1)));
  grid->AddCellAttribute(attribute("v", 2, space.Type, functions, values(2)));
  grid->AddCellAttribute(
    attribute("c", 1, space.Type, { "constant", "C", 0, false }, numbers(Cells, 1)));
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> cellsOf(vtkCellGrid* grid)
{
  std::string error;
  auto made = MadeGrids().replaceIn(grid, error);
  EXPECT_EQ(error, "");
  return vtkUnstructuredGrid::SafeDownCast(made);
}

vtkDGCell* typeOf(vtkCellGrid* grid, const std::string& type)
{
  return vtkDGCell::SafeDownCast(grid->GetCellType(vtkStringToken(type)));
}

std::vector<double> byVtk(
  vtkDGCell* type, vtkCellAttribute* attribute, vtkIdType cell, const vtkVector3d& place)
{
  const auto calculator = type->GetResponders()->AttributeCalculator<vtkInterpolateCalculator>(
    type, attribute, type->GetAttributeTags(attribute, true));
  std::vector<double> values(static_cast<std::size_t>(attribute->GetNumberOfComponents()));
  calculator->Evaluate(cell, place, values);
  return values;
}

vtkVector3d somewhereIn(vtkDGCell* type)
{
  vtkVector3d place(0, 0, 0);
  double sum = 0;
  std::vector<double> shares;
  for (int corner = 0; corner < type->GetNumberOfCorners(); ++corner)
  {
    shares.push_back(number());
    sum += shares.back();
  }
  for (int corner = 0; corner < type->GetNumberOfCorners(); ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] += shares[corner] / sum * type->GetCornerParameter(corner)[axis];
    }
  }
  return place;
}

// The parametric coordinates of VTK's cells.
std::array<double, 3> ofVtk(vtkDGCell* type, int vtkType, const vtkVector3d& place)
{
  std::array<double, 3> at{ { place[0], place[1], place[2] } };
  const vtkDGCell::Shape shape = type->GetShape();
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isSymmetric = shape == vtkDGCell::Hexahedron ||
                             (shape == vtkDGCell::Wedge && axis == 2) ||
                             vtkType == VTK_TRIQUADRATIC_PYRAMID;
    at[axis] = isSymmetric ? 0.5 + 0.5 * at[axis] : at[axis];
  }
  if (vtkType == VTK_PYRAMID)
  {
    at[0] = 0.5 + 0.5 * at[0] / (1 - at[2]);
    at[1] = 0.5 + 0.5 * at[1] / (1 - at[2]);
  }
  return at;
}

// All spaces of functions in three dimensions that VTK has.
std::vector<Space> knownSpaces()
{
  vtkFiltersCellGrid::RegisterCellsAndResponders();
  std::vector<Space> spaces;
  for (const auto& [basis, orders] : vtkDGCell::GetOperators()["Basis"_token]["HGRAD"_token])
  {
    for (const auto& [order, types] : orders)
    {
      for (const std::string type : { "vtkDGTet", "vtkDGHex", "vtkDGWdg", "vtkDGPyr" })
      {
        const auto found = types.find(vtkStringToken(type));
        if (found != types.end())
        {
          spaces.push_back(
            { type, { "HGRAD", basis.Data(), order }, found->second.NumberOfFunctions });
        }
      }
    }
  }
  return spaces;
}

class Spaces : public ::testing::TestWithParam<Space>
{
};

TEST_P(Spaces, CellsHaveTheirFunctions)
{
  const Space& space = GetParam();
  for (const bool shared : { false, true })
  {
    const auto grid = randomGrid(space, shared);
    const auto cells = cellsOf(grid);
    ASSERT_EQ(cells->GetNumberOfCells(), Cells);
    EXPECT_STREQ(cells->GetPointData()->GetScalars()->GetName(), "f");
    vtkDGCell* type = typeOf(grid, space.Type);
    vtkNew<vtkGenericCell> cell;
    for (vtkIdType i = 0; i < Cells; ++i)
    {
      cells->GetCell(i, cell);
      std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
      for (int sample = 0; sample < 20; ++sample)
      {
        const vtkVector3d place = somewhereIn(type);
        const auto at = ofVtk(type, cell->GetCellType(), place);
        std::array<double, 3> position;
        int part = 0;
        cell->EvaluateLocation(part, at.data(), position.data(), weights.data());
        const std::vector<double> wanted = byVtk(type, grid->GetShapeAttribute(), i, place);
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_NEAR(position[axis], wanted[axis], 1e-12);
        }
        for (const char* name : { "f", "v" })
        {
          const std::vector<double> values =
            byVtk(type, grid->GetCellAttributeByName(name), i, place);
          for (std::size_t c = 0; c < values.size(); ++c)
          {
            double value = 0;
            for (std::size_t point = 0; point < weights.size(); ++point)
            {
              value +=
                weights[point] * cells->GetPointData()->GetArray(name)->GetComponent(
                                   cell->GetPointId(static_cast<int>(point)), static_cast<int>(c));
            }
            EXPECT_NEAR(value, values[c], 1e-12);
          }
        }
        EXPECT_EQ(cells->GetCellData()->GetArray("c")->GetComponent(i, 0),
          byVtk(type, grid->GetCellAttributeByName("c"), i, place).front());
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(That, Spaces, ::testing::ValuesIn(knownSpaces()),
  [](const auto& tested)
  {
    const Space& space = tested.param;
    return space.Type + space.Functions.Basis + std::to_string(std::abs(space.Functions.Order));
  });

} // namespace
