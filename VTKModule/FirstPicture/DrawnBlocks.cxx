// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/DrawnBlocks.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace tetmarch
{

std::vector<vtkDataSet*> drawnBlocks(vtkDataObject* data)
{
  std::vector<vtkDataSet*> blocks;
  const auto add = [&blocks](vtkDataObject* block)
  {
    auto* dataSet = vtkDataSet::SafeDownCast(block);
    if (dataSet && !vtkPolyData::SafeDownCast(dataSet) && dataSet->GetNumberOfCells() > 0)
    {
      blocks.push_back(dataSet);
    }
  };
  if (auto* tree = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto at = vtk::TakeSmartPointer(tree->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      add(at->GetCurrentDataObject());
    }
  }
  else
  {
    add(data);
  }
  return blocks;
}

} // namespace tetmarch
