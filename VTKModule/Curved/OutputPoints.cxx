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

#include <cmath>
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

PiecePoint OutputPoints::copyOf(vtkIdType point)
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
    copy = this->insert(place, one).Id;
    this->Places.back() = this->firstAt(place.Position);
  }
  return this->point(copy);
}

// The last point is at this position.
std::uint32_t OutputPoints::firstAt(Vector3 position)
{
  const std::uint32_t last = this->Places.back();
  for (double& x : position)
  {
    if (!std::isfinite(x))
    {
      return last;
    }
    x += 0.0; // -0 is 0
  }
  const std::uint32_t first = this->FirstOfCopies.try_emplace(position, last).first->second;
  this->Shared = this->Shared || first != last;
  return first;
}

PiecePoint OutputPoints::insertAt(std::uint32_t other, const CurvedPlace& place, vtkIdList* mixed)
{
  CurvedPlace moved = place;
  moved.Position = this->position(other);
  const std::uint32_t id = this->insert(moved, mixed).Id;
  return { id, this->Places[id] = this->Places[other] };
}

PiecePoint OutputPoints::insert(const CurvedPlace& place, vtkIdList* mixed)
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
  this->Places.push_back(static_cast<std::uint32_t>(id));
  return this->point(id);
}

double OutputPoints::magnitude(vtkIdType point) const
{
  double squares = 0;
  for (std::size_t c = 0; c < this->Components; ++c)
  {
    squares += this->value(point, c) * this->value(point, c);
  }
  return std::sqrt(squares);
}

Vector3 OutputPoints::position(vtkIdType point) const
{
  Vector3 position;
  this->Points->GetPoint(point, position.data());
  return position;
}

} // namespace tetmarch
