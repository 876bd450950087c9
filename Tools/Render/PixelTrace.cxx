// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PixelTrace.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"

#include <algorithm>

namespace tetmarch
{

double GetCellValue(vtkTable* cells, const char* column, vtkIdType row, int component)
{
  return vtkDataArray::SafeDownCast(cells->GetColumnByName(column))->GetComponent(row, component);
}

double GetRayValue(vtkTable* cells, const char* name, int component)
{
  return cells->GetFieldData()->GetArray(name)->GetComponent(0, component);
}

std::array<double, 4> GetRayColor(vtkTable* cells)
{
  std::array<double, 4> color;
  for (int k = 0; k < 4; ++k)
  {
    color[k] = GetRayValue(cells, "Color", k);
  }
  return color;
}

vtkIdType FindParting(vtkTable* a, vtkTable* b)
{
  const vtkIdType inBoth = std::min(a->GetNumberOfRows(), b->GetNumberOfRows());
  for (vtkIdType row = 0; row < inBoth; ++row)
  {
    if (GetCellValue(a, "Tetrahedron", row) != GetCellValue(b, "Tetrahedron", row))
    {
      return row;
    }
  }
  return a->GetNumberOfRows() == b->GetNumberOfRows() ? -1 : inBoth;
}

} // namespace tetmarch
