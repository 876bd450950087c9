// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DefectGrids.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <utility>

namespace tetmarch::testing
{
namespace
{
Ids pointsOf(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  grid->GetCells()->GetCellAtId(cell, ids);
  return { ids->begin(), ids->end() };
}

// An empty grid with the points and the arrays' names of another one.
Grid withoutCells(vtkUnstructuredGrid* grid)
{
  auto result = Grid::New();
  result->SetPoints(grid->GetPoints());
  result->GetPointData()->ShallowCopy(grid->GetPointData());
  result->GetCellData()->CopyAllOn();
  result->GetCellData()->CopyAllocate(grid->GetCellData(), grid->GetNumberOfCells());
  result->Allocate(grid->GetNumberOfCells());
  return result;
}

void addTet(
  vtkUnstructuredGrid* result, const Ids& points, vtkUnstructuredGrid* from, vtkIdType cell)
{
  const vtkIdType id = result->InsertNextCell(VTK_TETRA, 4, points.data());
  result->GetCellData()->CopyData(from->GetCellData(), cell, id);
}
} // namespace

Grid withReversedCells(vtkUnstructuredGrid* grid, int every)
{
  Grid result = withoutCells(grid);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    Ids points = pointsOf(grid, cell);
    if (cell % every == 0)
    {
      std::swap(points[0], points[1]);
    }
    addTet(result, points, grid, cell);
  }
  return result;
}

Grid withRepeatedCells(vtkUnstructuredGrid* grid, int every)
{
  Grid result = withoutCells(grid);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    addTet(result, pointsOf(grid, cell), grid, cell);
  }
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); cell += every)
  {
    const Ids points = pointsOf(grid, cell);
    addTet(result, { points[3], points[1], points[0], points[2] }, grid, cell);
  }
  return result;
}

Grid withCrack(vtkUnstructuredGrid* lattice, int n)
{
  Grid result = withoutCells(lattice);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(lattice->GetPoints());
  vtkNew<vtkPointData> pointData;
  pointData->DeepCopy(lattice->GetPointData());
  vtkDataArray* f = pointData->GetArray("f");

  const int middle = n / 2;
  Ids copyOf(static_cast<std::size_t>(lattice->GetNumberOfPoints()), -1);
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j < middle; ++j)
    {
      const vtkIdType id = middle + (n + 1) * (j + (n + 1) * k);
      copyOf[id] = points->InsertNextPoint(lattice->GetPoint(id));
      f->InsertNextTuple(id, f);
    }
  }
  for (vtkIdType cell = 0; cell < lattice->GetNumberOfCells(); ++cell)
  {
    const bool isBeyond = cell / 6 % n >= middle;
    Ids corners = pointsOf(lattice, cell);
    for (vtkIdType& corner : corners)
    {
      corner = isBeyond && copyOf[corner] >= 0 ? copyOf[corner] : corner;
    }
    addTet(result, corners, lattice, cell);
  }
  result->SetPoints(points);
  result->GetPointData()->ShallowCopy(pointData);
  return result;
}
} // namespace tetmarch::testing
