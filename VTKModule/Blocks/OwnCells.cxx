// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/OwnCells.h"

#include "Input/DataCheck.h"
#include "Scalars/DrawnScalars.h"
#include "Scalars/GhostArrays.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

namespace tetmarch
{
namespace
{

// The values of these cells, if there is an array.
vtkSmartPointer<vtkDataArray> valuesOf(vtkDataArray* array, const std::vector<vtkIdType>& cells)
{
  vtkSmartPointer<vtkDataArray> values;
  if (array)
  {
    values.TakeReference(array->NewInstance());
    values->SetName(array->GetName());
    values->SetNumberOfComponents(array->GetNumberOfComponents());
    values->SetNumberOfTuples(static_cast<vtkIdType>(cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      values->SetTuple(static_cast<vtkIdType>(i), cells[i], array);
    }
  }
  return values;
}

// These cells and all points. vtkUnstructuredGrid::RemoveGhostCells() of VTK 9.1 does not end if
// there are polyhedra.
vtkSmartPointer<vtkUnstructuredGrid> gridOf(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& cells)
{
  const auto kept = vtkSmartPointer<vtkUnstructuredGrid>::New();
  kept->Allocate(static_cast<vtkIdType>(cells.size()));
  kept->SetPoints(grid->GetPoints());
  vtkNew<vtkIdList> ids;
  for (const vtkIdType cell : cells)
  {
    const int type = grid->GetCellType(cell);
    type == VTK_POLYHEDRON ? grid->GetFaceStream(cell, ids) : grid->GetCellPoints(cell, ids);
    kept->InsertNextCell(type, ids);
  }
  return kept;
}

} // namespace

void OwnCells::update(
  vtkUnstructuredGrid* grid, vtkDataArray* scalars, bool ofCells, const CellOrigins& origins)
{
  Fingerprint input;
  add(input, grid); // and its ghost arrays, whose changes are those of the grid
  add(input, scalars);
  input.push_back(origins.of(0).Block); // the grid of a single block is its own
  if (input == this->MadeFrom)
  {
    return;
  }
  this->MadeFrom.clear();
  this->Grid = grid;
  this->Scalars = scalars;
  this->Origins = origins;
  const GhostArrays ghosts = ghostArraysOf(grid);
  const auto isValid = [&]
  { return checkData(grid).empty() && (!scalars || checkScalars(grid, scalars, ofCells).empty()); };
  if (!hasAny(ghosts.OfCells, vtkDataSetAttributes::DUPLICATECELL) || !isValid())
  {
    this->MadeFrom = input;
    return;
  }
  std::vector<vtkIdType> cells;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if (!(ghosts.OfCells->GetValue(i) & vtkDataSetAttributes::DUPLICATECELL))
    {
      cells.push_back(i);
    }
  }
  this->Grid = gridOf(grid, cells);
  if (const auto marks = valuesOf(ghosts.OfCells, cells))
  {
    this->Grid->GetCellData()->AddArray(marks);
  }
  if (ghosts.OfPoints)
  {
    this->Grid->GetPointData()->AddArray(ghosts.OfPoints);
  }
  this->Scalars = ofCells ? valuesOf(scalars, cells) : vtkSmartPointer<vtkDataArray>(scalars);
  this->Origins.renumber(std::move(cells));
  this->MadeFrom = input;
}

} // namespace tetmarch
