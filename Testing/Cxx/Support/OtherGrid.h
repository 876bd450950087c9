// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A vtkUnstructuredGridBase of one tetrahedron that is no vtkUnstructuredGrid
 */
#ifndef tetmarch_testing_OtherGrid_h
#define tetmarch_testing_OtherGrid_h

#include "Input/GridVersions.h"

#include "vtkCellIterator.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"
#include "vtkTetra.h"
#include "vtkUnstructuredGridBase.h"

namespace tetmarch::testing
{
class OtherGrid : public vtkUnstructuredGridBase
{
public:
  static OtherGrid* New()
  {
    auto* grid = new OtherGrid;
    grid->InitializeObjectBase();
    return grid;
  }
  vtkTypeMacro(OtherGrid, vtkUnstructuredGridBase);

  vtkIdType GetNumberOfCells() override { return 1; }
  vtkCell* GetCell(vtkIdType) override { return this->Tetra; }
  using vtkUnstructuredGridBase::GetCell;
  void GetCell(vtkIdType, vtkGenericCell* cell) override { cell->SetCellTypeToTetra(); }
  int GetCellType(vtkIdType) override { return VTK_TETRA; }
  void GetCellPoints(vtkIdType, vtkIdList* points) override { points->Reset(); }
  void GetPointCells(vtkIdType, vtkIdList* cells) override { cells->Reset(); }
  int GetMaxCellSize() override { return 4; }
  vtkCellIterator* NewCellIterator() override { return nullptr; }
  void Allocate(vtkIdType, int) override {}
  void GetIdsOfCellsOfType(int, vtkIdTypeArray*) override {}
  int IsHomogeneous() override { return 1; }

protected:
  OtherGrid()
  {
    vtkNew<vtkPoints> corners;
    corners->InsertNextPoint(0.0, 0.0, 0.0);
    corners->InsertNextPoint(1.0, 0.0, 0.0);
    corners->InsertNextPoint(0.0, 1.0, 0.0);
    corners->InsertNextPoint(0.0, 0.0, 1.0);
    this->SetPoints(corners);
  }

  vtkIdType InternalInsertNextCell(int, vtkIdList*) override { return -1; }
  vtkIdType InternalInsertNextCell(int, vtkIdType, const vtkIdType[]) override { return -1; }
#if TETMARCH_FACES_ARE_STREAMS
  vtkIdType InternalInsertNextCell(
    int, vtkIdType, const vtkIdType[], vtkIdType, const vtkIdType[]) override
  {
    return -1;
  }
#else
  vtkIdType InternalInsertNextCell(int, vtkIdType, const vtkIdType[], vtkCellArray*) override
  {
    return -1;
  }
#endif
  void InternalReplaceCell(vtkIdType, int, const vtkIdType[]) override {}

private:
  vtkNew<vtkTetra> Tetra;
};
} // namespace tetmarch::testing

#endif
