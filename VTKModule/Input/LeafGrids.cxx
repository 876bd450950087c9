// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/LeafGrids.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridToUnstructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <array>

namespace tetmarch
{
namespace
{

Fingerprint versionOf(vtkHyperTreeGrid* tree)
{
  Fingerprint version;
  add(version, tree);
  add(version, tree->GetCellData());
  add(version, tree->HasMask() ? tree->GetMask() : nullptr);
  add(version, tree->GetXCoordinates());
  add(version, tree->GetYCoordinates());
  add(version, tree->GetZCoordinates());
  return version;
}

// Empty, or why the tree's cells can't be read: its coordinates, mask or arrays are too short.
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

} // namespace

LeafGrids::LeafGrid LeafGrids::gridOf(vtkHyperTreeGrid* tree)
{
  const Fingerprint version = versionOf(tree);
  const auto made = this->Made.find(tree);
  if (made != this->Made.end() && made->second.MadeFrom == version)
  {
    return made->second;
  }
  vtkNew<vtkHyperTreeGridToUnstructuredGrid> leaves;
  leaves->SetInputDataObject(tree);
  leaves->Update();
  return { version, vtkUnstructuredGrid::SafeDownCast(leaves->GetOutputDataObject(0)) };
}

vtkSmartPointer<vtkDataObject> LeafGrids::replaceTrees(vtkDataObject* input, std::string& error)
{
  GridsOfTrees found;
  const auto replacementOf = [&](vtkHyperTreeGrid* tree) -> vtkDataObject*
  {
    error = error.empty() ? checkTree(tree) : error;
    return error.empty() ? (found[tree] = this->gridOf(tree)).Grid.Get() : nullptr;
  };
  vtkSmartPointer<vtkDataObject> drawn = input;
  if (auto* tree = vtkHyperTreeGrid::SafeDownCast(input))
  {
    drawn = replacementOf(tree);
  }
  else if (auto* blocks = vtkDataObjectTree::SafeDownCast(input))
  {
    const auto at = vtk::TakeSmartPointer(blocks->NewTreeIterator());
    vtkSmartPointer<vtkDataObjectTree> copy;
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      if (auto* block = vtkHyperTreeGrid::SafeDownCast(at->GetCurrentDataObject()))
      {
        if (!copy)
        {
          copy.TakeReference(blocks->NewInstance());
          copy->ShallowCopy(blocks);
          drawn = copy;
        }
        copy->SetDataSet(at, replacementOf(block));
      }
    }
  }
  this->Made.swap(found);
  return error.empty() ? drawn : nullptr;
}

} // namespace tetmarch
