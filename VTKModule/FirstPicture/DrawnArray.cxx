// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture/DrawnArray.h"

#include "Scalars/StoredScalar.h"
#include "Scalars/TupleCheck.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetmarch
{

namespace
{

// Components beyond these bounds have squares that lose digits or overflow.
constexpr double LeastSquared = 1e-140;
constexpr double MostSquared = 1e140;

vtkDataArray* arrayOf(vtkDataSet* block, const DrawnArray& drawn)
{
  vtkDataSetAttributes* attributes = drawn.OfCells
                                       ? static_cast<vtkDataSetAttributes*>(block->GetCellData())
                                       : block->GetPointData();
  return attributes->GetArray(drawn.Array->GetName());
}

// Whether vtkDataArray::GetFiniteRange() may miss values: it ignores those beyond VTK_DOUBLE_MAX,
// and computes the magnitude from squares.
bool isExtreme(vtkDataArray* array, bool magnitude)
{
  double most = 0;
  for (int i = 0; i < array->GetNumberOfComponents(); ++i)
  {
    double range[2];
    array->GetFiniteRange(range, i);
    most = std::max({ most, std::abs(range[0]), std::abs(range[1]) });
  }
  return magnitude ? !(most > LeastSquared && most < MostSquared) : most >= VTK_DOUBLE_MAX;
}

} // namespace

DrawnValues::DrawnValues(vtkDataSet* block, const DrawnArray& drawn)
  : OfCells(drawn.OfCells)
  , Component(drawn.Component)
{
  vtkDataArray* array = arrayOf(block, drawn);
  if (array && drawn.Component < array->GetNumberOfComponents() &&
      checkTuples(block, array, drawn.OfCells).empty())
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
  return square > LeastSquared * LeastSquared && square < MostSquared * MostSquared
           ? std::sqrt(square)
           : this->magnitudeOfExtremes(tuple);
}

// As in Scalars/TupleScalar.h.
double DrawnValues::magnitudeOfExtremes(vtkIdType tuple) const
{
  double length = 0;
  for (int i = 0; i < this->Array->GetNumberOfComponents(); ++i)
  {
    const double component = this->Array->GetComponent(tuple, i);
    if (!std::isfinite(component))
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    length = std::hypot(length, component);
  }
  return std::min(length, std::numeric_limits<double>::max());
}

std::optional<std::array<double, 2>> DrawnValues::range() const
{
  std::array<double, 2> range;
  this->Array->GetFiniteRange(range.data(), this->Component);
  if (isExtreme(this->Array, this->Component < 0))
  {
    FiniteRange found;
    for (vtkIdType i = 0; i < this->Array->GetNumberOfTuples(); ++i)
    {
      found.add(this->at(i));
    }
    range = { { found.low(), found.high() } };
  }
  return range[0] <= range[1] ? std::make_optional(range) : std::nullopt;
}

std::optional<std::array<double, 2>> rangeOf(
  const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn)
{
  FiniteRange all;
  for (vtkDataSet* block : blocks)
  {
    const DrawnValues values(block, drawn);
    if (const auto part = values ? values.range() : std::nullopt)
    {
      all.add((*part)[0]);
      all.add((*part)[1]);
    }
  }
  return all.low() <= all.high()
           ? std::make_optional(std::array<double, 2>{ all.low(), all.high() })
           : std::nullopt;
}

std::string checkLengths(const std::vector<vtkDataSet*>& blocks, const DrawnArray& drawn)
{
  for (vtkDataSet* block : blocks)
  {
    vtkDataArray* array = arrayOf(block, drawn);
    std::string wrong = array ? checkTuples(block, array, drawn.OfCells) : std::string();
    if (!wrong.empty())
    {
      return wrong;
    }
  }
  return {};
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
