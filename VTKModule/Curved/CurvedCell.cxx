// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/CurvedCell.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

namespace tetmarch
{
namespace
{

constexpr int FirstToApex = 9; // the point in the middle of the edge from corner 0 to the apex

} // namespace

CurvedCell::CurvedCell(vtkUnstructuredGrid* grid, vtkDataArray* scalars)
  : Grid(grid)
  , Scalars(scalars)
{
}

void CurvedCell::read(vtkIdType cell, const CurvedShape& shape)
{
  this->Grid->GetCell(cell, this->Cell);
  this->IsPyramid = shape.Kind == CurvedKind::Pyramid;
  this->IsCollapsed = this->IsPyramid && this->Cell->GetParametricCoords()[3 * FirstToApex] == 0;
  this->PointValues.clear();
  if (this->Scalars)
  {
    for (vtkIdType i = 0; i < this->points()->GetNumberOfIds(); ++i)
    {
      for (int c = 0; c < this->Scalars->GetNumberOfComponents(); ++c)
      {
        this->PointValues.push_back(this->Scalars->GetComponent(this->points()->GetId(i), c));
      }
    }
  }
}

void CurvedCell::evaluate(const Vector3& at, CurvedPlace& place)
{
  Vector3 parameters = at;
  if (this->IsCollapsed)
  {
    const double width = 1 - at[2]; // of the square at that height
    for (int k = 0; k < 2; ++k)
    {
      parameters[k] = width > 0 ? 0.5 + (at[k] - 0.5) / width : 0.5;
    }
  }
  else if (this->IsPyramid)
  {
    parameters[2] = 0.5 + 0.5 * at[2]; // from vtkTriQuadraticPyramid's base to its apex
  }
  const auto points = static_cast<std::size_t>(this->points()->GetNumberOfIds());
  place.Weights.resize(points);
  int part = 0;
  this->Cell->EvaluateLocation(
    part, parameters.data(), place.Position.data(), place.Weights.data());
  const std::size_t components = this->PointValues.size() / points;
  place.Values.assign(components, 0);
  for (std::size_t i = 0; i < points; ++i)
  {
    for (std::size_t c = 0; c < components; ++c)
    {
      place.Values[c] += place.Weights[i] * this->PointValues[i * components + c];
    }
  }
}

} // namespace tetmarch
