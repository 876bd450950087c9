// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/GhostArrays.h"

#include "vtkDataSet.h"
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

} // namespace tetmarch
