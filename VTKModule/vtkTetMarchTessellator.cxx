// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetMarchTessellator.h"

#include "Caching/WithinMemory.h"
#include "Curved/Tessellation.h"
#include "Input/GridCheck.h"
#include "Scalars/TupleCheck.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <string>

vtkStandardNewMacro(vtkTetMarchTessellator);

namespace
{

// All arrays are read.
std::string errorOf(vtkUnstructuredGrid* grid)
{
  std::string error = tetmarch::checkGrid(grid);
  for (const bool ofCells : { false, true })
  {
    vtkDataSetAttributes* arrays =
      grid->GetAttributes(ofCells ? vtkDataObject::CELL : vtkDataObject::POINT);
    for (int i = 0; error.empty() && i < arrays->GetNumberOfArrays(); ++i)
    {
      error = tetmarch::checkTuples(grid, arrays->GetAbstractArray(i), ofCells);
    }
  }
  return error;
}

} // namespace

vtkTetMarchTessellator::vtkTetMarchTessellator()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

void vtkTetMarchTessellator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GeometryTolerance: " << this->GeometryTolerance << endl;
  os << indent << "ScalarTolerance: " << this->ScalarTolerance << endl;
}

int vtkTetMarchTessellator::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  std::string error = errorOf(input);
  if (error.empty() && input->GetNumberOfCells() > 0)
  {
    const tetmarch::CurvedTolerance tolerance = tetmarch::toleranceOf(input,
      this->GetInputArrayToProcess(0, inputVector), this->GeometryTolerance, this->ScalarTolerance);
    const auto progress = [this](double done)
    {
      this->UpdateProgress(done);
      return this->GetAbortExecute() == 0;
    };
    const std::string shortage = tetmarch::withinMemory(
      "the tetrahedra of curved cells within these tolerances",
      [&] { error = tetmarch::tessellate(input, tolerance, progress, output); },
      "so the output is empty");
    error = error.empty() ? shortage : error;
  }
  if (!error.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< error);
  }
  return 1;
}
