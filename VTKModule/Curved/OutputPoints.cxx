// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/OutputPoints.h"

#include "Input/GridCheck.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <stdexcept>

namespace tetmarch
{

OutputPoints::OutputPoints(
  vtkUnstructuredGrid* grid, vtkDataArray* scalars, vtkUnstructuredGrid* output)
  : Grid(grid)
  , Scalars(scalars)
  , Output(output)
  , Components(scalars ? static_cast<std::size_t>(scalars->GetNumberOfComponents()) : 0)
  , Copies(static_cast<std::size_t>(grid->GetNumberOfPoints()), -1)
{
  this->Points->SetDataTypeToDouble();
  output->SetPoints(this->Points);
  vtkPointData* attributes = output->GetPointData();
  attributes->CopyGlobalIdsOff();
  attributes->CopyPedigreeIdsOff();
  attributes->CopyRationalWeightsOff();
  attributes->CopyFieldOff(vtkDataSetAttributes::GhostArrayName());
  attributes->InterpolateAllocate(grid->GetPointData());
}

OutputPoints::~OutputPoints() = default;

vtkIdType OutputPoints::copyOf(vtkIdType point)
{
  vtkIdType& copy = this->Copies[static_cast<std::size_t>(point)];
  if (copy < 0)
  {
    CurvedPlace place;
    this->Grid->GetPoint(point, place.Position.data());
    place.Weights = { 1 };
    for (std::size_t c = 0; c < this->Components; ++c)
    {
      place.Values.push_back(this->Scalars->GetComponent(point, static_cast<int>(c)));
    }
    vtkNew<vtkIdList> one;
    one->InsertNextId(point);
    copy = this->insert(place, one);
  }
  return copy;
}

vtkIdType OutputPoints::insert(const CurvedPlace& place, vtkIdList* mixed)
{
  const vtkIdType id = this->Points->InsertNextPoint(place.Position.data());
  if (id >= MostPointsOrCells)
  {
    throw std::length_error("points");
  }
  // VTK's interface asks for a pointer through which it doesn't write.
  this->Output->GetPointData()->InterpolatePoint(
    this->Grid->GetPointData(), id, mixed, const_cast<double*>(place.Weights.data()));
  this->Values.insert(this->Values.end(), place.Values.begin(), place.Values.end());
  return id;
}

Vector3 OutputPoints::position(vtkIdType point) const
{
  Vector3 position;
  this->Points->GetPoint(point, position.data());
  return position;
}

} // namespace tetmarch
