// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/BlockList.h"

#include "Input/GridContent.h"

#include "vtkAbstractMapper.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace tetmarch
{
namespace
{

std::string nameOf(vtkCompositeDataIterator* at)
{
  const char* name =
    at->HasCurrentMetaData() ? at->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? '"' + std::string(name) + '"'
              : "number " + std::to_string(at->GetCurrentFlatIndex());
}

Block blockOf(vtkDataSet* data, const ScalarSelection& selection)
{
  int cellFlag = 0;
  vtkDataArray* scalars = vtkAbstractMapper::GetScalars(
    data, selection.Mode, selection.AccessMode, selection.Id, selection.Name, cellFlag);
  const bool drawable = scalars && cellFlag != 2 && scalars->GetNumberOfComponents() > 0;
  return { data, 0, {}, drawable ? scalars : nullptr, cellFlag == 1 };
}

} // namespace

std::vector<Block> listBlocks(vtkDataObject* input, const ScalarSelection& selection)
{
  std::vector<Block> blocks;
  if (auto* alone = vtkDataSet::SafeDownCast(input))
  {
    blocks.push_back(blockOf(alone, selection));
  }
  auto* tree = vtkCompositeDataSet::SafeDownCast(input);
  const auto at = vtk::TakeSmartPointer(tree ? tree->NewIterator() : nullptr);
  for (tree ? at->InitTraversal() : void(); tree && !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    auto* data = vtkDataSet::SafeDownCast(at->GetCurrentDataObject());
    if (!data || vtkPolyData::SafeDownCast(data))
    {
      continue;
    }
    blocks.push_back(blockOf(data, selection));
    blocks.back().FlatIndex = at->GetCurrentFlatIndex();
    blocks.back().Name = nameOf(at);
  }
  return blocks;
}

void chooseOfEither(Block& block, ScalarSelection selection)
{
  const bool ofCells = selection.Mode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
  if (block.Scalars || (!ofCells && selection.Mode != VTK_SCALAR_MODE_USE_POINT_FIELD_DATA))
  {
    return;
  }
  selection.Mode =
    ofCells ? VTK_SCALAR_MODE_USE_POINT_FIELD_DATA : VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
  const Block found = blockOf(block.Data, selection);
  block.Scalars = found.Scalars;
  block.CellScalars = found.CellScalars;
}

void boundBlocks(vtkDataObject* input, double bounds[6])
{
  vtkBoundingBox box;
  for (const Block& block : listBlocks(input, {}))
  {
    if (block.Data->GetNumberOfPoints() > 0)
    {
      box.AddBounds(block.Data->GetBounds());
    }
  }
  vtkMath::UninitializeBounds(bounds);
  if (box.IsValid())
  {
    box.GetBounds(bounds);
  }
}

Fingerprint shapeOf(const std::vector<Block>& blocks)
{
  Fingerprint shape;
  for (const Block& block : blocks)
  {
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(block.Data))
    {
      add(shape, versionOf(grid));
      const char* ghosts = vtkDataSetAttributes::GhostArrayName();
      add(shape, grid->GetPointData()->GetGlobalIds());
      add(shape, grid->GetPointData()->GetArray(ghosts));
      add(shape, grid->GetCellData()->GetArray(ghosts));
    }
    else
    {
      add(shape, block.Data);
    }
    shape.push_back(block.FlatIndex);
    shape.push_back(block.Scalars ? 1 + block.CellScalars : 0);
    shape.push_back(block.Scalars ? block.Scalars->GetNumberOfComponents() : 0);
  }
  return shape;
}

Fingerprint scalarsOf(const std::vector<Block>& blocks)
{
  Fingerprint scalars;
  for (const Block& block : blocks)
  {
    add(scalars, block.Scalars);
  }
  return scalars;
}

} // namespace tetmarch
