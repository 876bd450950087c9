// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/LeafGrids.h"

#include "Input/TreeCheck.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridToUnstructuredGrid.h"
#include "vtkUnstructuredGrid.h"

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
