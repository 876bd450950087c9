// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/MadeGrids.h"

#include "Input/TreeLeafCells.h"
#ifdef TETMARCH_HAS_CELL_GRIDS
#include "Input/CellGridCells.h"
#endif

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

struct Kind
{
  const char* Type;
  Fingerprint (*VersionOf)(vtkDataObject* data);
  std::string (*Make)(vtkDataObject* data, vtkSmartPointer<vtkUnstructuredGrid>& grid);
};

const Kind Kinds[] = {
  { "vtkHyperTreeGrid", versionOfTree, makeLeafCells },
#ifdef TETMARCH_HAS_CELL_GRIDS
  { "vtkCellGrid", versionOfCellGrid, makeCellsOfCellGrid },
#endif
};

const Kind* kindOf(vtkDataObject* data)
{
  const auto* kind = std::find_if(std::begin(Kinds), std::end(Kinds),
    [data](const Kind& known) { return data && data->IsA(known.Type); });
  return kind == std::end(Kinds) ? nullptr : kind;
}

} // namespace

bool isGridMadeOf(vtkDataObject* data) { return kindOf(data) != nullptr; }

void forEachTypeOfMadeGrids(const std::function<void(const char*)>& callback)
{
  for (const Kind& kind : Kinds)
  {
    callback(kind.Type);
  }
}

MadeGrids::MadeGrid MadeGrids::gridOf(vtkDataObject* data, std::string& error)
{
  const Kind& kind = *kindOf(data);
  const Fingerprint version = kind.VersionOf(data);
  const auto made = this->Made.find(data);
  if (made != this->Made.end() && made->second.Grid && made->second.MadeFrom == version)
  {
    return made->second;
  }
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  error = kind.Make(data, grid);
  return error.empty() ? MadeGrid{ version, grid } : MadeGrid();
}

bool MadeGrids::isOfCellGrid(vtkDataObject* grid) const
{
  return std::any_of(this->Made.begin(), this->Made.end(),
    [grid](const auto& made)
    { return made.second.Grid == grid && made.first->IsA("vtkCellGrid"); });
}

vtkSmartPointer<vtkDataObject> MadeGrids::replaceIn(vtkDataObject* input, std::string& error)
{
  GridsByData found;
  const auto replacementOf = [&](vtkDataObject* data) -> vtkDataObject*
  {
    if (error.empty())
    {
      found[data] = this->gridOf(data, error);
    }
    return error.empty() ? found[data].Grid.Get() : nullptr;
  };
  vtkSmartPointer<vtkDataObject> drawn = input;
  if (isGridMadeOf(input))
  {
    drawn = replacementOf(input);
  }
  else if (auto* blocks = vtkDataObjectTree::SafeDownCast(input))
  {
    const auto at = vtk::TakeSmartPointer(blocks->NewTreeIterator());
    vtkSmartPointer<vtkDataObjectTree> copy;
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      vtkDataObject* block = at->GetCurrentDataObject();
      if (isGridMadeOf(block))
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
