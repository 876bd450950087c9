// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Leaves/LeafList.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"

#include <cstring>

namespace tetmarch
{

void LeafList::add(const Leaf& leaf, bool shown, int source, vtkIdType tuple)
{
  if (shown)
  {
    this->Shown.push_back(leaf);
    this->Origins.push_back({ source, tuple });
  }
  else
  {
    this->Hidden.push_back(leaf);
  }
}

Leaves LeafList::made(
  std::array<LeafAxis, 3> axes, const std::vector<std::vector<vtkDataArray*>>& arrays) const
{
  Leaves leaves;
  leaves.Axes = std::move(axes);
  leaves.All = this->Shown;
  leaves.All.insert(leaves.All.end(), this->Hidden.begin(), this->Hidden.end());
  leaves.Shown = this->Shown.size();
  for (std::size_t i = 0; !arrays.empty() && i < arrays.front().size(); ++i)
  {
    vtkDataArray* first = arrays.front()[i];
    auto values = vtkSmartPointer<vtkDataArray>::Take(first->NewInstance());
    values->SetName(first->GetName());
    values->SetNumberOfComponents(first->GetNumberOfComponents());
    values->CopyComponentNames(first);
    values->SetNumberOfTuples(static_cast<vtkIdType>(leaves.Shown));
    for (std::size_t l = 0; l < leaves.Shown; ++l)
    {
      const auto& [source, tuple] = this->Origins[l];
      values->SetTuple(static_cast<vtkIdType>(l), tuple, arrays[source][i]);
    }
    leaves.Arrays.push_back(values);
  }
  return leaves;
}

std::vector<vtkDataArray*> valueArraysOf(vtkCellData* data)
{
  std::vector<vtkDataArray*> arrays;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (array && array->GetName() &&
        std::strcmp(array->GetName(), vtkDataSetAttributes::GhostArrayName()) != 0)
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}

std::string activeScalarsOf(vtkCellData* data)
{
  vtkDataArray* scalars = data->GetScalars();
  return scalars && scalars->GetName() ? scalars->GetName() : std::string();
}

} // namespace tetmarch
