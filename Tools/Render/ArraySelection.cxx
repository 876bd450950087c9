// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ArraySelection.h"

#include "Failure.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <algorithm>
#include <set>

namespace
{
using tetmarch::ArraySelection;
using tetmarch::Association;

vtkDataSetAttributes* GetAttributes(vtkDataSet* block, Association where)
{
  return where == Association::POINTS ? static_cast<vtkDataSetAttributes*>(block->GetPointData())
                                      : block->GetCellData();
}

/// Arrays of numbers with a name, without those that VTK uses itself. Of arrays of one name the
/// first.
std::vector<ArraySelection> ListArrays(const std::vector<vtkDataSet*>& blocks, Association where)
{
  std::vector<ArraySelection> selections;
  std::set<std::string> names{ "vtkGhostType" };
  for (vtkDataSet* block : blocks)
  {
    vtkDataSetAttributes* attributes = GetAttributes(block, where);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      if (array && array->GetName() && names.insert(array->GetName()).second)
      {
        selections.push_back({ array, where, 0 });
      }
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

ArraySelection SelectArray(const std::vector<vtkDataSet*>& blocks, const std::string& name,
  std::optional<Association> where, int component)
{
  std::vector<ArraySelection> all = ListArrays(blocks, Association::POINTS);
  for (const ArraySelection& selection : ListArrays(blocks, Association::CELLS))
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
    throw Failure((name.empty() ? "the data has no array to draw" + place
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

vtkDataArray* FindArray(vtkDataSet* block, const ArraySelection& selection)
{
  return GetAttributes(block, selection.Where)->GetArray(selection.Array->GetName());
}

std::array<double, 2> GetRange(
  const std::vector<vtkDataSet*>& blocks, const ArraySelection& selection)
{
  std::array<double, 2> range{ { VTK_DOUBLE_MAX, VTK_DOUBLE_MIN } };
  for (vtkDataSet* block : blocks)
  {
    vtkDataArray* array = FindArray(block, selection);
    if (array && selection.Component < array->GetNumberOfComponents())
    {
      double part[2];
      array->GetRange(part, selection.Component);
      range = { { std::min(range[0], part[0]), std::max(range[1], part[1]) } };
    }
  }
  return range;
}

} // namespace tetmarch
