// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/OutputCells.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <utility>

namespace tetmarch
{

OutputCells::OutputCells(
  vtkUnstructuredGrid* grid, OutputPoints& points, vtkUnstructuredGrid* output)
  : Grid(grid)
  , Points(points)
  , Output(output)
{
}

OutputCells::~OutputCells() = default;

void OutputCells::pass(vtkIdType cell)
{
  const int type = this->Grid->GetCellType(cell);
  vtkNew<vtkIdList> ids;
  if (type == VTK_POLYHEDRON)
  {
    this->Grid->GetFaceStream(cell, ids);
    vtkIdType place = 1;
    for (vtkIdType face = 0; face < ids->GetId(0); ++face)
    {
      const vtkIdType last = place + ids->GetId(place);
      for (++place; place <= last; ++place)
      {
        ids->SetId(place, this->Points.copyOf(ids->GetId(place)).Id);
      }
    }
  }
  else
  {
    this->Grid->GetCells()->GetCellAtId(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      ids->SetId(i, this->Points.copyOf(ids->GetId(i)).Id);
    }
  }
  this->Output->InsertNextCell(type, ids);
  this->Origins->InsertNextValue(cell);
}

void OutputCells::insert(vtkIdType cell, const Piece& piece)
{
  std::array<vtkIdType, 4> ids;
  std::array<Vector3, 4> points;
  for (int i = 0; i < 4; ++i)
  {
    ids[i] = piece[i].Point.Id;
    points[i] = this->Points.position(ids[i]);
  }
  if (dot(cross(points[1] - points[0], points[2] - points[0]), points[3] - points[0]) < 0)
  {
    std::swap(ids[1], ids[2]);
  }
  this->Output->InsertNextCell(VTK_TETRA, 4, ids.data());
  this->Origins->InsertNextValue(cell);
}

void OutputCells::finish()
{
  vtkCellData* attributes = this->Output->GetCellData();
  attributes->CopyHigherOrderDegreesOff();
  attributes->CopyGlobalIdsOff();
  attributes->CopyPedigreeIdsOff();
  attributes->CopyAllocate(this->Grid->GetCellData(), this->Origins->GetNumberOfValues());
  for (vtkIdType i = 0; i < this->Origins->GetNumberOfValues(); ++i)
  {
    attributes->CopyData(this->Grid->GetCellData(), this->Origins->GetValue(i), i);
  }
  this->Origins->SetName(OriginalCells);
  attributes->AddArray(this->Origins);
  this->Output->GetFieldData()->PassData(this->Grid->GetFieldData());
  this->Output->Squeeze();
}

} // namespace tetmarch
