// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cell grids of VTK 9.5 and later: cells of one type with a shape and a field "f"
 */
#ifndef tetmarch_testing_CellGrids_h
#define tetmarch_testing_CellGrids_h

#include "vtkCell.h"
#include "vtkCellAttribute.h"
#include "vtkCellGrid.h"
#include "vtkDGCell.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFiltersCellGrid.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <string>
#include <vector>

namespace tetmarch::testing
{
using namespace vtk::literals;

/// The functions of a shape or of a field.
struct FunctionsOfCells
{
  std::string Space = "HGRAD";
  std::string Basis = "C";
  int Order = 1;
  bool Shared = false; ///< between cells, by the grid's connectivity
};

/// A grid with cells of this type (such as "vtkDGHex"), a row of ids for each.
inline vtkSmartPointer<vtkCellGrid> cellGrid(const std::string& type, vtkTypeInt64Array* cells)
{
  vtkFiltersCellGrid::RegisterCellsAndResponders();
  auto grid = vtkSmartPointer<vtkCellGrid>::New();
  auto* metadata = vtkDGCell::SafeDownCast(grid->AddCellMetadata(vtkStringToken(type)));
  cells->SetName("connectivity");
  grid->GetAttributes(vtkStringToken(type))->SetScalars(cells);
  metadata->GetCellSpec().Connectivity = cells;
  metadata->GetCellSpec().SourceShape = metadata->GetShape();
  return grid;
}

/// An attribute with these values: of shared functions a tuple for each id, else one for each cell.
inline vtkSmartPointer<vtkCellAttribute> attribute(const std::string& name, int components,
  const std::string& type, const FunctionsOfCells& functions, vtkDoubleArray* values)
{
  vtkCellAttribute::CellTypeInfo info;
  info.DOFSharing = functions.Shared ? vtkStringToken("shared") : vtkStringToken();
  info.FunctionSpace = functions.Space;
  info.Basis = functions.Basis;
  info.Order = functions.Order;
  info.ArraysByRole["values"_token] = values;
  auto made = vtkSmartPointer<vtkCellAttribute>::New();
  made->Initialize(name, "R", components);
  made->SetCellTypeInfo(type, info);
  return made;
}

/// For each function of a space the point of a cell of VTK at which it is 1 and others are 0. The
/// cell's parametric coordinates become those of the type: 0..1 or -1..1.
inline std::vector<int> pointsOfFunctions(
  vtkDGCell* type, vtkCell* cell, const FunctionsOfCells& functions)
{
  vtkCellAttribute::CellTypeInfo info;
  info.FunctionSpace = functions.Space;
  info.Basis = functions.Basis;
  info.Order = functions.Order;
  const auto basis = type->GetOperatorEntry("Basis"_token, info);
  std::vector<int> points(static_cast<std::size_t>(basis.NumberOfFunctions), -1);
  std::vector<double> values(points.size());
  const bool isSymmetric = type->GetShape() == vtkDGCell::Hexahedron;
  for (int point = 0; point < cell->GetNumberOfPoints(); ++point)
  {
    std::array<double, 3> at;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = cell->GetParametricCoords()[3 * point + axis];
      at[axis] = isSymmetric ? 2 * x - 1 : x;
    }
    basis.Op(at, values);
    for (std::size_t function = 0; function < values.size(); ++function)
    {
      points[function] = values[function] > 0.999 ? point : points[function];
    }
  }
  return points;
}

/// The cells of a grid, which are all of one type, with its point scalars as the field "f": shared,
/// or, repeated, with values of each cell's own.
inline vtkSmartPointer<vtkCellGrid> cellGridOf(
  vtkUnstructuredGrid* grid, const std::string& type, const FunctionsOfCells& functions)
{
  vtkNew<vtkTypeInt64Array> cells;
  const auto empty = cellGrid(type, cells);
  const std::vector<int> order = pointsOfFunctions(
    vtkDGCell::SafeDownCast(empty->GetCellType(vtkStringToken(type))), grid->GetCell(0), functions);
  const auto count = static_cast<int>(order.size());
  cells->SetNumberOfComponents(count);
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkDoubleArray> scalars;
  positions->SetNumberOfComponents(3);
  scalars->SetNumberOfComponents(functions.Shared ? 1 : count);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    for (const int point : order)
    {
      const vtkIdType id = grid->GetCell(cell)->GetPointId(point);
      cells->InsertNextValue(id);
      functions.Shared
        ? vtkIdType()
        : scalars->InsertNextValue(grid->GetPointData()->GetScalars()->GetComponent(id, 0));
    }
  }
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    positions->InsertNextTuple(grid->GetPoint(id));
    functions.Shared
      ? scalars->InsertNextValue(grid->GetPointData()->GetScalars()->GetComponent(id, 0))
      : vtkIdType();
  }
  FunctionsOfCells ofShape = functions;
  ofShape.Shared = true;
  empty->SetShapeAttribute(attribute("shape", 3, type, ofShape, positions));
  empty->AddCellAttribute(attribute("f", 1, type, functions, scalars));
  return empty;
}
} // namespace tetmarch::testing

#endif
