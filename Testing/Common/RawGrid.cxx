// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RawGrid.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

namespace tetmarch::testing
{
RawGrid::RawGrid(vtkUnstructuredGrid* grid)
  : Offsets(valuesOf(grid->GetCells()->GetOffsetsArray()))
  , Connectivity(valuesOf(grid->GetCells()->GetConnectivityArray()))
  , Faces(grid)
  , HasFaces(facesOf(grid) != nullptr)
{
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double p[3];
    grid->GetPoint(i, p);
    this->Points.insert(this->Points.end(), p, p + 3);
  }
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    this->Types.push_back(static_cast<unsigned char>(grid->GetCellType(i)));
  }
}

Grid RawGrid::grid() const
{
  vtkNew<vtkPoints> points;
  points->SetDataType(this->FloatPoints ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(static_cast<vtkIdType>(this->Points.size() / 3));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, &this->Points[3 * i]);
  }
  vtkNew<vtkCellArray> cells;
  if (this->Wide)
  {
    cells->SetData(arrayOf<vtkTypeInt64Array>(this->Offsets).Get(),
      arrayOf<vtkTypeInt64Array>(this->Connectivity).Get());
  }
  else
  {
    cells->SetData(arrayOf<vtkTypeInt32Array>(this->Offsets).Get(),
      arrayOf<vtkTypeInt32Array>(this->Connectivity).Get());
  }
  auto grid = Grid::New();
  grid->SetPoints(points);
  setCells(grid, arrayOf<vtkUnsignedCharArray>(this->Types), cells,
    this->HasFaces ? this->Faces.locations() : nullptr,
    this->HasFaces ? this->Faces.faces() : nullptr);
  return grid;
}
} // namespace tetmarch::testing
