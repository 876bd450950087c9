// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/SolidCells.h"

#include "Input/CellKind.h"
#include "Input/CellTypes.h"

#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace tetmarch
{

bool isSolidType(int type)
{
  const CellCut cut = cellKinds()[static_cast<unsigned char>(type)].Cut;
  return cut != CellCut::Empty && cut != CellCut::LowDimensional;
}

bool hasSolidCells(vtkDataSet* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    const CellTypes types(grid);
    for (vtkIdType i = 0; types.array() && i < types.array()->GetNumberOfTuples(); ++i)
    {
      if (isSolidType(types[i]))
      {
        return true;
      }
    }
    return false;
  }
  if (vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data))
  {
    return !isSlice(data);
  }
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (isSolidType(data->GetCellType(cell)))
    {
      return true;
    }
  }
  return false;
}

bool isSlice(vtkDataSet* data)
{
  int n[3] = { 2, 2, 2 };
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(n);
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    grid->GetDimensions(n);
  }
  return *std::min_element(n, n + 3) < 2;
}

} // namespace tetmarch
