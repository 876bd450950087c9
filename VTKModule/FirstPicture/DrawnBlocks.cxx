// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/DrawnBlocks.h"

#include "Input/SolidCells.h"
#include "Scalars/GhostArrays.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace tetmarch
{

namespace
{

std::vector<vtkDataObject*> leavesOf(vtkDataObject* data)
{
  std::vector<vtkDataObject*> leaves;
  if (auto* tree = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto at = vtk::TakeSmartPointer(tree->NewIterator());
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

vtkSmartPointer<vtkDataSet> withoutMisfits(vtkDataSet* block)
{
  const GhostArrays fitting = ghostArraysOf(block);
  if (block->GetCellGhostArray() == fitting.OfCells &&
      block->GetPointGhostArray() == fitting.OfPoints)
  {
    return block;
  }
  auto copy = vtk::TakeSmartPointer(block->NewInstance());
  copy->ShallowCopy(block);
  const char* name = vtkDataSetAttributes::GhostArrayName();
  for (const int place : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    if (!(place == vtkDataObject::CELL ? fitting.OfCells : fitting.OfPoints))
    {
      copy->GetAttributes(place)->RemoveArray(name);
    }
  }
  return copy;
}

} // namespace

std::vector<vtkSmartPointer<vtkDataSet>> drawnBlocks(vtkDataObject* data)
{
  std::vector<vtkSmartPointer<vtkDataSet>> blocks;
  for (vtkDataObject* leaf : leavesOf(data))
  {
    auto* block = vtkDataSet::SafeDownCast(leaf);
    if (block && !vtkPolyData::SafeDownCast(block) && block->GetNumberOfCells() > 0 &&
        !isSlice(block))
    {
      blocks.push_back(withoutMisfits(block));
    }
  }
  return blocks;
}

vtkMTimeType timeOf(vtkDataObject* data)
{
  vtkMTimeType time = data->GetMTime();
  for (vtkDataObject* leaf : leavesOf(data))
  {
    time = std::max(time, leaf->GetMTime());
  }
  return time;
}

} // namespace tetmarch
