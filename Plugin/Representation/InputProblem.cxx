// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputProblem.h"

#include "CellGrids.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkGenericCell.h"
#include "vtkHyperTreeGrid.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <vector>

namespace
{

bool hasSolids(vtkDataSet* data)
{
  if (vtkPolyData::SafeDownCast(data))
  {
    return false;
  }
  if (auto* curvilinear = vtkStructuredGrid::SafeDownCast(data))
  {
    return curvilinear->GetDataDimension() == 3;
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (!grid)
  {
    return true;
  }
  vtkNew<vtkGenericCell> cell;
  vtkUnsignedCharArray* types = grid->GetDistinctCellTypesArray();
  for (vtkIdType i = 0; types && i < types->GetNumberOfValues(); ++i)
  {
    cell->SetCellType(types->GetValue(i));
    if (cell->GetCellDimension() == 3)
    {
      return true;
    }
  }
  return false;
}

// The data, or its blocks if it is a tree.
std::vector<vtkDataObject*> leavesOf(vtkDataObject* data)
{
  std::vector<vtkDataObject*> leaves;
  if (auto* blocks = vtkDataObjectTree::SafeDownCast(data))
  {
    const auto at = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(blocks->NewTreeIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      leaves.push_back(at->GetCurrentDataObject());
    }
  }
  else
  {
    leaves.push_back(data);
  }
  return leaves;
}

} // namespace

namespace tetmarch
{

const char* arrayOf(vtkInformation* colors)
{
  return colors && colors->Has(vtkDataObject::FIELD_NAME())
           ? colors->Get(vtkDataObject::FIELD_NAME())
           : nullptr;
}

void InputProblem::lookAt(vtkDataObject* input)
{
  this->HasData = input != nullptr;
  if (!input)
  {
    return;
  }
  enum
  {
    CELLS,
    SOLIDS,
    ARRAYS,
    NUMBERS
  };
  long long found[NUMBERS] = {};
  for (vtkDataSet* data : vtkCompositeDataSet::GetDataSets(input))
  {
    const long long cells = data->GetNumberOfCells();
    found[CELLS] += cells;
    found[SOLIDS] += cells > 0 && hasSolids(data) ? cells : 0;
    found[ARRAYS] +=
      data->GetPointData()->GetNumberOfArrays() + data->GetCellData()->GetNumberOfArrays();
  }
  for (vtkDataObject* leaf : leavesOf(input))
  {
    if (auto* tree = vtkHyperTreeGrid::SafeDownCast(leaf))
    {
      const long long cells = tree->GetNumberOfLeaves();
      found[CELLS] += cells;
      found[SOLIDS] += tree->GetDimension() == 3 ? cells : 0;
      found[ARRAYS] += tree->GetCellData()->GetNumberOfArrays();
    }
    else if (tetmarch::isCellGrid(leaf))
    {
      const tetmarch::CellGridNumbers numbers = tetmarch::numbersOfCellGrid(leaf);
      found[CELLS] += numbers.Cells;
      found[SOLIDS] += numbers.Cells;
      found[ARRAYS] += numbers.Fields;
    }
  }
  long long all[NUMBERS];
  std::copy_n(found, NUMBERS, all);
  auto* processes = vtkMultiProcessController::GetGlobalController();
  if (processes && processes->GetNumberOfProcesses() > 1)
  {
    processes->AllReduce(found, all, NUMBERS, vtkCommunicator::SUM_OP);
  }
  this->Cells = all[CELLS];
  this->Solids = all[SOLIDS];
  this->HasArrays = all[ARRAYS] > 0;
}

std::string InputProblem::textFor(const char* array) const
{
  if (this->Cells == 0)
  {
    return "The data has no cells, so Tet Marching draws nothing.";
  }
  if (this->Solids == 0)
  {
    return "None of the " + std::to_string(this->Cells) +
           " cells of the data is three-dimensional, so Tet Marching draws nothing. Show such "
           "cells "
           "as Surface.";
  }
  if (array && *array)
  {
    return "";
  }
  return this->HasArrays
           ? "Tet Marching draws the values of an array, but the data has a solid color. Choose an "
             "array under Coloring."
           : "Tet Marching draws the values of an array, but the data has neither point nor cell "
             "arrays. Add one by a filter, for instance Elevation or Calculator, and choose it "
             "under Coloring.";
}

void InputProblem::warn(vtkObject* representation, const char* array)
{
  const std::string text = this->HasData ? this->textFor(array) : "";
  const bool isNew = text != this->Said;
  this->Said = text;
  auto* processes = vtkMultiProcessController::GetGlobalController();
  if (isNew && !text.empty() && (!processes || processes->GetLocalProcessId() == 0))
  {
    vtkWarningWithObjectMacro(representation, << text);
  }
}

} // namespace tetmarch
