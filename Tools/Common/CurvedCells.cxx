// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CurvedCells.h"

#include "ErrorText.h"
#include "Failure.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkTetMarchFirstPicture.h"
#include "vtkTetMarchTessellator.h"

vtkSmartPointer<vtkUnstructuredGrid> tetmarch::CutCurvedCells(
  vtkUnstructuredGrid* grid, const WantedArray& wanted, const ProgressReport& report)
{
  vtkNew<vtkTetMarchFirstPicture> choice;
  const ErrorText why(choice);
  choice->SetInputData(grid);
  choice->SetArrayName(wanted.Name);
  choice->SetArrayAssociation(wanted.Association);
  if (!choice->ChooseArray())
  {
    throw Failure(why.Get());
  }
  vtkNew<vtkTetMarchTessellator> cut;
  const ErrorText error(cut);
  cut->SetGeometryTolerance(wanted.Curves->Geometry);
  cut->SetScalarTolerance(wanted.Curves->Scalar);
  cut->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, choice->GetChosenArray()->GetName());
  cut->SetInputData(grid);
  ProgressBar progress("cutting curved cells", cut, report);
  cut->Update();
  if (progress.IsStopped())
  {
    throw Cancelled("cutting curved cells was cancelled");
  }
  if (!error.Get().empty())
  {
    throw Failure(error.Get());
  }
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = cut->GetOutput();
  tetrahedra->GetCellData()->RemoveArray("vtkOriginalCellIds"); // which isn't the file's
  return tetrahedra;
}
