// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/GridContent.h"

#include "Input/GridVersions.h"
#include "Input/HigherOrderCheck.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace tetmarch
{
namespace
{

vtkDataArray* offsetsOf(vtkCellArray* cells) { return cells ? cells->GetOffsetsArray() : nullptr; }
vtkDataArray* valuesOf(vtkCellArray* cells)
{
  return cells ? cells->GetConnectivityArray() : nullptr;
}

// Streams are found by the locations.
[[maybe_unused]] vtkDataArray* offsetsOf(vtkIdTypeArray*) { return nullptr; }
[[maybe_unused]] vtkDataArray* valuesOf(vtkIdTypeArray* streams) { return streams; }

std::array<int, 3> dimensionsOf(vtkPointSet* grid)
{
  std::array<int, 3> dimensions{};
  if (auto* curvilinear = vtkStructuredGrid::SafeDownCast(grid))
  {
    curvilinear->GetDimensions(dimensions.data());
  }
  return dimensions;
}

} // namespace

GridContent::Versions GridContent::versionsOf(vtkPointSet* data)
{
  const auto version = [](vtkObject* owner, vtkDataArray* array) -> Version
  {
    return { owner, array,
      array ? std::max(owner ? owner->GetMTime() : 0, array->GetMTime()) : vtkMTimeType(0) };
  };
  vtkPoints* points = data->GetPoints();
  Versions versions{};
  // Points come first.
  versions[0] = version(points, points ? points->GetData() : nullptr);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (!grid)
  {
    return versions;
  }
  vtkCellArray* cells = grid->GetCells();
  FaceArray* faces = facesOf(grid);
  FaceArray* locations = faceLocationsOf(grid);
  const HigherOrderArrays higherOrder(grid);
  return { { versions[0], version(cells, offsetsOf(cells)), version(cells, valuesOf(cells)),
    version(nullptr, cellTypesOf(grid)), version(faces, offsetsOf(faces)),
    version(faces, valuesOf(faces)), version(locations, offsetsOf(locations)),
    version(locations, valuesOf(locations)), version(nullptr, higherOrder.Degrees),
    version(nullptr, higherOrder.Weights) } };
}

Fingerprint versionOf(vtkPointSet* grid)
{
  Fingerprint fingerprint;
  fingerprint.reserve(4 * GridContent::NumberOfArrays); // callers add to it
  for (const int n : dimensionsOf(grid))
  {
    fingerprint.push_back(static_cast<std::uintptr_t>(n));
  }
  for (const GridContent::Version& version : GridContent::versionsOf(grid))
  {
    fingerprint.push_back(reinterpret_cast<std::uintptr_t>(version.Owner));
    fingerprint.push_back(reinterpret_cast<std::uintptr_t>(version.Array));
    fingerprint.push_back(static_cast<std::uintptr_t>(version.Time));
  }
  return fingerprint;
}

void GridContent::read(vtkPointSet* grid)
{
  this->Dimensions = dimensionsOf(grid);
  const Versions versions = versionsOf(grid);
  for (std::size_t i = 0; i < NumberOfArrays; ++i)
  {
    if (!(versions[i] == this->Read[i]))
    {
      this->Hashes[i] = contentHashOf(versions[i].Array);
      this->Read[i] = versions[i];
    }
  }
}

bool GridContent::operator==(const GridContent& other) const
{
  return this->Hashes == other.Hashes && this->Dimensions == other.Dimensions;
}

bool GridContent::hasCellsOf(const GridContent& other) const
{
  return this->Dimensions == other.Dimensions &&
         std::equal(this->Hashes.begin() + 1, this->Hashes.end(), other.Hashes.begin() + 1,
           other.Hashes.end());
}

} // namespace tetmarch
