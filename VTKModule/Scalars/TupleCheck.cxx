// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/TupleCheck.h"

#include "vtkAbstractArray.h"
#include "vtkDataSet.h"

namespace tetmarch
{

std::string checkTuples(vtkDataSet* data, vtkAbstractArray* array, bool ofCells)
{
  const vtkIdType count = ofCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  if (array->GetNumberOfTuples() == count)
  {
    return {};
  }
  return std::string("The scalar array \"") + (array->GetName() ? array->GetName() : "") +
         "\" has " + std::to_string(array->GetNumberOfTuples()) + " tuples, but the grid has " +
         std::to_string(count) + (ofCells ? " cells." : " points.");
}

} // namespace tetmarch
