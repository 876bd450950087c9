// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/GhostArrays.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

vtkUnsignedCharArray* fitting(vtkUnsignedCharArray* ghosts, vtkIdType count)
{
  const bool fits =
    ghosts && ghosts->GetNumberOfComponents() == 1 && ghosts->GetNumberOfTuples() == count;
  return fits ? ghosts : nullptr;
}

} // namespace

GhostArrays ghostArraysOf(vtkDataSet* data)
{
  return { fitting(data->GetCellGhostArray(), data->GetNumberOfCells()),
    fitting(data->GetPointGhostArray(), data->GetNumberOfPoints()) };
}

bool hasAny(vtkUnsignedCharArray* ghosts, unsigned char bits)
{
  if (!ghosts)
  {
    return false;
  }
  const unsigned char* values = ghosts->GetPointer(0);
  return std::any_of(values, values + ghosts->GetNumberOfValues(),
    [bits](unsigned char value) { return (value & bits) != 0; });
}

std::vector<bool> cellsOfHiddenPoints(vtkDataSet* grid, vtkUnsignedCharArray* ofPoints)
{
  std::vector<bool> found(static_cast<std::size_t>(grid->GetNumberOfCells()));
  vtkNew<vtkIdList> points;
  for (std::size_t cell = 0; cell < found.size(); ++cell)
  {
    grid->GetCellPoints(static_cast<vtkIdType>(cell), points);
    found[cell] = std::any_of(points->begin(), points->end(),
      [ofPoints](vtkIdType point) { return (ofPoints->GetValue(point) & HidingPoint) != 0; });
  }
  return found;
}

} // namespace tetmarch
