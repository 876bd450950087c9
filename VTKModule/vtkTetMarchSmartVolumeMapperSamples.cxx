// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance between samples along a ray, as vtkSmartVolumeMapper chooses it.
#include "vtkTetMarchSmartVolumeMapper.h"

#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
struct Spacing
{
  std::array<double, 3> Of{}; // along the axes
  std::array<int, 6> Extent{};
  double least() const { return *std::min_element(this->Of.begin(), this->Of.end()); }
};

// That of a rectilinear grid is its sides over its numbers of points, as VTK's mappers have it.
Spacing spacingOf(vtkDataSet* data)
{
  Spacing spacing;
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetSpacing(spacing.Of.data());
    image->GetExtent(spacing.Extent.data());
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    double bounds[6];
    int points[3];
    grid->GetBounds(bounds);
    grid->GetDimensions(points);
    grid->GetExtent(spacing.Extent.data());
    for (int a = 0; a < 3; ++a)
    {
      spacing.Of[a] = (bounds[2 * a + 1] - bounds[2 * a]) / points[a];
    }
  }
  for (double& along : spacing.Of)
  {
    along = std::abs(along);
  }
  return spacing;
}
} // namespace

//------------------------------------------------------------------------------
double vtkTetMarchSmartVolumeMapper::FindSampleDistance(vtkDataSet* data, double rayDistance)
{
  if (rayDistance == 0 && !this->LockSampleDistanceToInputSpacing && !(this->SampleDistance < 0))
  {
    return double(this->SampleDistance);
  }
  Spacing spacing = spacingOf(data);
  return rayDistance > 0
           ? spacing.least() * rayDistance
           : this->SpacingAdjustedSampleDistance(spacing.Of.data(), spacing.Extent.data());
}
