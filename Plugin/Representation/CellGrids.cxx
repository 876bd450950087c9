// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellGrids.h"

#include "vtkDataObject.h"
#if __has_include("vtkCellGrid.h")
#include "vtkCellAttribute.h"
#include "vtkCellGrid.h"
#endif

namespace tetmarch
{

bool isCellGrid(vtkDataObject* data) { return data && data->IsA("vtkCellGrid"); }

#if __has_include("vtkCellGrid.h")
CellGridNumbers numbersOfCellGrid(vtkDataObject* grid)
{
  auto* cells = vtkCellGrid::SafeDownCast(grid);
  CellGridNumbers numbers;
  numbers.Cells = cells->GetNumberOfCells();
  for (const auto& attribute : cells->GetCellAttributeList())
  {
    numbers.Fields += attribute != cells->GetShapeAttribute() ? 1 : 0;
  }
  return numbers;
}

vtkBoundingBox boundsOfCellGrid(vtkDataObject* grid)
{
  double bounds[6];
  vtkCellGrid::SafeDownCast(grid)->GetBounds(bounds);
  return vtkBoundingBox(bounds);
}
#else
CellGridNumbers numbersOfCellGrid(vtkDataObject*) { return {}; }
vtkBoundingBox boundsOfCellGrid(vtkDataObject*) { return {}; }
#endif

} // namespace tetmarch
