// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ArraySelection.h"

#include "Failure.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

namespace
{
using tetmarch::ArraySelection;
using tetmarch::Association;

/// Arrays of numbers with a name, without those that VTK uses itself.
std::vector<ArraySelection> ListArrays(vtkUnstructuredGrid* grid, Association where)
{
  vtkDataSetAttributes* attributes = where == Association::POINTS
                                       ? static_cast<vtkDataSetAttributes*>(grid->GetPointData())
                                       : grid->GetCellData();
  std::vector<ArraySelection> selections;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i);
    if (array && array->GetName() && std::string(array->GetName()) != "vtkGhostType")
    {
      selections.push_back({ array, where, 0 });
    }
  }
  return selections;
}

/// 0 is best.
int GetRank(const ArraySelection& selection)
{
  double range[2];
  selection.Array->GetRange(range, 0);
  if (!(range[0] < range[1]))
  {
    return 3;
  }
  const int type = selection.Array->GetDataType();
  const bool floating = type == VTK_FLOAT || type == VTK_DOUBLE;
  return !floating ? 2 : selection.Array->GetNumberOfComponents() > 1 ? 1 : 0;
}

std::string Describe(const std::vector<ArraySelection>& selections)
{
  std::string text;
  for (const Association where : { Association::POINTS, Association::CELLS })
  {
    std::string names;
    for (const ArraySelection& selection : selections)
    {
      if (selection.Where == where)
      {
        names += (names.empty() ? "" : ", ") + std::string(selection.Array->GetName());
      }
    }
    text += std::string(where == Association::POINTS ? "on points: " : "; on cells: ") +
            (names.empty() ? "none" : names);
  }
  return text;
}
} // namespace

namespace tetmarch
{

ArraySelection SelectArray(vtkUnstructuredGrid* grid, const std::string& name,
  std::optional<Association> where, int component)
{
  std::vector<ArraySelection> all = ListArrays(grid, Association::POINTS);
  for (const ArraySelection& selection : ListArrays(grid, Association::CELLS))
  {
    all.push_back(selection);
  }
  const ArraySelection* best = nullptr;
  for (const ArraySelection& selection : all)
  {
    if (where && selection.Where != *where)
    {
      continue;
    }
    if (!name.empty() ? name == selection.Array->GetName() && !best
                      : !best || GetRank(selection) < GetRank(*best))
    {
      best = &selection;
    }
  }
  if (!best)
  {
    const std::string place = !where                          ? ""
                              : *where == Association::POINTS ? " on points"
                                                              : " on cells";
    throw Failure((name.empty() ? "the grid has no array to draw" + place
                                : "there is no array '" + name + "'" + place) +
                  " (" + Describe(all) + ")");
  }
  ArraySelection selection = *best;
  const int components = selection.Array->GetNumberOfComponents();
  if (component >= components)
  {
    throw Failure(std::string("array '") + selection.Array->GetName() + "' has no component " +
                  std::to_string(component) + ": it has " + std::to_string(components) +
                  ", counted from 0");
  }
  selection.Component = components == 1 ? 0 : component;
  return selection;
}

} // namespace tetmarch
