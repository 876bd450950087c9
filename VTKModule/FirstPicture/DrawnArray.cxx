// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/DrawnArray.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cmath>

namespace tetmarch
{

DrawnValues::DrawnValues(vtkDataSet* block, const DrawnArray& drawn)
  : OfCells(drawn.OfCells)
  , Component(drawn.Component)
{
  vtkDataSetAttributes* attributes = drawn.OfCells
                                       ? static_cast<vtkDataSetAttributes*>(block->GetCellData())
                                       : block->GetPointData();
  vtkDataArray* array = attributes->GetArray(drawn.Array->GetName());
  if (array && drawn.Component < array->GetNumberOfComponents())
  {
    this->Array = array;
  }
}

double DrawnValues::at(vtkIdType tuple) const
{
  if (this->Component >= 0)
  {
    return this->Array->GetComponent(tuple, this->Component);
  }
  double square = 0;
  for (int i = 0; i < this->Array->GetNumberOfComponents(); ++i)
  {
    const double component = this->Array->GetComponent(tuple, i);
    square += component * component;
  }
  return std::sqrt(square);
}

std::array<double, 2> DrawnValues::range() const
{
  std::array<double, 2> range;
  this->Array->GetFiniteRange(range.data(), this->Component);
  return range;
}

std::array<double, 2> rangeOf(const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn)
{
  std::array<double, 2> range{ { VTK_DOUBLE_MAX, VTK_DOUBLE_MIN } };
  for (vtkDataSet* block : blocks)
  {
    if (const DrawnValues values(block, drawn); values)
    {
      const std::array<double, 2> part = values.range();
      range = { { std::min(range[0], part[0]), std::max(range[1], part[1]) } };
    }
  }
  return range;
}

bool isLattice(vtkDataSet* block, int dimensions[3])
{
  if (auto* image = vtkImageData::SafeDownCast(block))
  {
    image->GetDimensions(dimensions);
    return true;
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(block))
  {
    grid->GetDimensions(dimensions);
    return true;
  }
  return false;
}

} // namespace tetmarch
