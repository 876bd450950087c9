// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeData.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
double GetMeanDistance(vtkDataArray* coordinates)
{
  const vtkIdType last = coordinates->GetNumberOfTuples() - 1;
  return std::abs(coordinates->GetComponent(last, 0) - coordinates->GetComponent(0, 0)) /
         static_cast<double>(std::max<vtkIdType>(last, 1));
}

double GetMeanSpacingOf(vtkDataSet* data)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    const double* spacing = image->GetSpacing();
    return (std::abs(spacing[0]) + std::abs(spacing[1]) + std::abs(spacing[2])) / 3.0;
  }
  auto* grid = vtkRectilinearGrid::SafeDownCast(data);
  return (GetMeanDistance(grid->GetXCoordinates()) + GetMeanDistance(grid->GetYCoordinates()) +
           GetMeanDistance(grid->GetZCoordinates())) /
         3.0;
}
} // namespace

namespace tetmarch
{

bool IsStructured(vtkDataObject* data)
{
  return vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data);
}

void GetDimensions(vtkDataSet* data, int dimensions[3])
{
  auto* image = vtkImageData::SafeDownCast(data);
  image ? image->GetDimensions(dimensions)
        : vtkRectilinearGrid::SafeDownCast(data)->GetDimensions(dimensions);
}

std::array<double, 6> GetBounds(const VolumeData& volume)
{
  vtkBoundingBox box;
  for (vtkDataSet* block : volume.Blocks)
  {
    box.AddBounds(block->GetBounds());
  }
  std::array<double, 6> bounds;
  box.GetBounds(bounds.data());
  return bounds;
}

double GetMeanSpacing(const VolumeData& volume)
{
  double sum = 0.0;
  for (vtkDataSet* block : volume.Blocks)
  {
    sum += GetMeanSpacingOf(block);
  }
  return sum / static_cast<double>(volume.Blocks.size());
}

} // namespace tetmarch
