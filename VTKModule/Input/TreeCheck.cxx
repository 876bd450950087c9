// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/TreeCheck.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkHyperTreeGrid.h"

#include <array>

namespace tetmarch
{

std::string checkTree(vtkHyperTreeGrid* tree)
{
  const std::array<vtkDataArray*, 3> coordinates{ { tree->GetXCoordinates(),
    tree->GetYCoordinates(), tree->GetZCoordinates() } };
  const unsigned int* points = tree->GetDimensions();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!coordinates[axis] || coordinates[axis]->GetNumberOfTuples() < vtkIdType(points[axis]))
    {
      return "The tree has " + std::to_string(points[axis]) + " points along axis " +
             std::to_string(axis) + ", but fewer coordinates.";
    }
  }
  const vtkIdType cells = tree->GetGlobalNodeIndexMax() + 1;
  if (tree->HasMask() && tree->GetMask()->GetNumberOfTuples() < cells)
  {
    return "The tree's mask has " + std::to_string(tree->GetMask()->GetNumberOfTuples()) +
           " values, but the tree has " + std::to_string(cells) + " cells.";
  }
  vtkCellData* data = tree->GetCellData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array->GetNumberOfTuples() < cells)
    {
      return "The array \"" + std::string(array->GetName() ? array->GetName() : "") + "\" has " +
             std::to_string(array->GetNumberOfTuples()) + " tuples, but the tree has " +
             std::to_string(cells) + " cells.";
    }
  }
  return {};
}

} // namespace tetmarch
