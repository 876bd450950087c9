// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CaseOptics.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace tetmarch::testing
{
namespace
{
constexpr double StandardDepthOfDiagonal = 11.0; // times the mean opacity: about 3

double at(const Range& range, double t) { return (1.0 - t) * range.Low + t * range.High; }

void setOpticsOver(const Range& range, vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
{
  setStandardColours(property, range);
  setStandardOpacities(property, range);
  setDepthOfDiagonal(property, grid, StandardDepthOfDiagonal);
}
} // namespace

Range finiteRange(vtkDataArray* values)
{
  bool any = false;
  Range range = { 0.0, 1.0 };
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    if (std::isfinite(value))
    {
      range.Low = any ? std::min(range.Low, value) : value;
      range.High = any ? std::max(range.High, value) : value;
      any = true;
    }
  }
  if (range.Low == range.High)
  {
    const double width = range.Low != 0.0 ? std::abs(range.Low) : 1.0;
    range = { range.Low - 0.3 * width, range.Low + 0.7 * width };
  }
  return range;
}

void setStandardColours(vtkVolumeProperty* property, const Range& range)
{
  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(at(range, 0.0), 0.1, 0.2, 1.0);
  colour->AddRGBPoint(at(range, 0.4), 0.1, 0.9, 0.5);
  colour->AddRGBPoint(at(range, 0.7), 1.0, 0.9, 0.1);
  colour->AddRGBPoint(at(range, 1.0), 1.0, 0.1, 0.1);
  property->SetColor(colour);
}

void setStandardOpacities(vtkVolumeProperty* property, const Range& range)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  const double nodes[][2] = { { 0.0, 0.05 }, { 0.2, 0.1 }, { 0.3, 0.7 }, { 0.4, 0.1 },
    { 0.45, 0.0 }, { 0.6, 0.0 }, { 1.0, 0.9 } };
  for (const auto& node : nodes)
  {
    opacity->AddPoint(at(range, node[0]), node[1]);
  }
  property->SetScalarOpacity(opacity);
}

void setDepthOfDiagonal(vtkVolumeProperty* property, vtkUnstructuredGrid* grid, double depth)
{
  property->SetScalarOpacityUnitDistance(grid->GetLength() / depth);
}

OpticsSetter standardOpticsOver(const Range& range)
{
  return [range](vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
  { setOpticsOver(range, property, grid); };
}

OpticsSetter standardOpticsOfCells()
{
  return [](vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
  { setOpticsOver(finiteRange(grid->GetCellData()->GetArray("c")), property, grid); };
}

OpticsSetter withRamps(const OpticsSetter& setter)
{
  return [setter](vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
  {
    (setter ? setter : setStandardOptics)(property, grid);
    const Range range = finiteRange(grid->GetPointData()->GetArray("f"));
    vtkNew<vtkColorTransferFunction> colour;
    colour->AddRGBPoint(range.Low, 0.1, 0.3, 1.0);
    colour->AddRGBPoint(range.High, 1.0, 0.7, 0.1);
    property->SetColor(colour);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(range.Low, 0.1);
    opacity->AddPoint(range.High, 0.6);
    property->SetScalarOpacity(opacity);
  };
}

void setStandardOptics(vtkVolumeProperty* property, vtkUnstructuredGrid* grid)
{
  setOpticsOver(finiteRange(grid->GetPointData()->GetArray("f")), property, grid);
}
} // namespace tetmarch::testing
