// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SelectedBlocks.h"

#include "vtkDataAssembly.h"
#include "vtkDataAssemblyUtilities.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <vector>

namespace tetmarch
{
namespace
{

using FlatIndices = std::set<unsigned int>;

// Of blocks, and of vtkPartitionedDataSets instead of their partitions.
bool findSelected(vtkDataObjectTree* tree, const BlockSelection& selection, FlatIndices& selected)
{
  const std::vector<std::string> paths(selection.Selectors.begin(), selection.Selectors.end());
  std::vector<unsigned int> indices;
  if (selection.Assembly == vtkDataAssemblyUtilities::HierarchyName())
  {
    vtkNew<vtkDataAssembly> hierarchy;
    if (!vtkDataAssemblyUtilities::GenerateHierarchy(tree, hierarchy))
    {
      return false;
    }
    // What a hierarchy has for indices of data sets are the flat ones.
    indices = hierarchy->GetDataSetIndices(hierarchy->SelectNodes(paths));
  }
  else
  {
    auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(tree);
    if (!collection || !collection->GetDataAssembly())
    {
      return false;
    }
    indices = vtkDataAssemblyUtilities::GetSelectedCompositeIds(
      paths, collection->GetDataAssembly(), collection);
  }
  selected = FlatIndices(indices.begin(), indices.end());
  return true;
}

} // namespace

vtkSmartPointer<vtkDataObjectTree> selectBlocks(
  vtkDataObjectTree* tree, const BlockSelection& selection)
{
  auto result = vtkSmartPointer<vtkDataObjectTree>::Take(tree->NewInstance());
  result->ShallowCopy(tree);
  FlatIndices selected;
  if (!findSelected(tree, selection, selected))
  {
    return result;
  }
  const auto at = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  at->VisitOnlyLeavesOff();
  at->SkipEmptyNodesOff();
  unsigned int partitions = 0; // that are still to come, of a selected data set
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    const bool chosen = selected.count(at->GetCurrentFlatIndex()) > 0;
    vtkDataObject* data = at->GetCurrentDataObject();
    if (auto* partitioned = vtkPartitionedDataSet::SafeDownCast(data))
    {
      partitions = chosen ? partitioned->GetNumberOfPartitions() : 0;
    }
    else if (partitions > 0)
    {
      --partitions;
    }
    else if (!chosen && data && !vtkDataObjectTree::SafeDownCast(data))
    {
      result->SetDataSet(at, nullptr);
    }
  }
  return result;
}

} // namespace tetmarch
