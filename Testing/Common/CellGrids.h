// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cell grids of VTK 9.5 and later: cells of one type with a shape and a field "f"
 */
#ifndef tetmarch_testing_CellGrids_h
#define tetmarch_testing_CellGrids_h

#include "vtkCellAttribute.h"
#include "vtkCellGrid.h"
#include "vtkDGCell.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFiltersCellGrid.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt64Array.h"

#include <string>

namespace tetmarch::testing
{
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
  info.ArraysByRole["values"] = values;
  auto made = vtkSmartPointer<vtkCellAttribute>::New();
  made->Initialize(name, "R", components);
  made->SetCellTypeInfo(type, info);
  return made;
}
} // namespace tetmarch::testing

#endif
