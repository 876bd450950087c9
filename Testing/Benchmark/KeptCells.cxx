// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "KeptCells.h"

#include "vtkExtractCells.h"
#include "vtkNew.h"

namespace tetmarch::bench
{
vtkSmartPointer<vtkUnstructuredGrid> keepCells(vtkUnstructuredGrid* grid, const IsKept& isKept)
{
  vtkNew<vtkIdList> kept, points;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, points);
    if (isKept(points))
    {
      kept->InsertNextId(cell);
    }
  }
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(grid);
  extract->SetCellList(kept);
  extract->Update();
  return extract->GetOutput();
}

std::array<double, 3> centerOf(vtkUnstructuredGrid* grid, vtkIdList* points)
{
  std::array<double, 3> center{};
  for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
  {
    const double* point = grid->GetPoint(points->GetId(i));
    for (int k = 0; k < 3; ++k)
    {
      center[k] += point[k] / static_cast<double>(points->GetNumberOfIds());
    }
  }
  return center;
}
} // namespace tetmarch::bench
