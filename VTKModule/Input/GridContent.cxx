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

} // namespace

GridContent::Versions GridContent::versionsOf(vtkUnstructuredGrid* grid)
{
  const auto version = [](vtkObject* owner, vtkDataArray* array) -> Version
  {
    return { owner, array,
      array ? std::max(owner ? owner->GetMTime() : 0, array->GetMTime()) : vtkMTimeType(0) };
  };
  vtkPoints* points = grid->GetPoints();
  vtkCellArray* cells = grid->GetCells();
  FaceArray* faces = facesOf(grid);
  FaceArray* locations = faceLocationsOf(grid);
  const HigherOrderArrays higherOrder(grid);
  // Points come first.
  return { { version(points, points ? points->GetData() : nullptr),
    version(cells, offsetsOf(cells)), version(cells, valuesOf(cells)),
    version(nullptr, cellTypesOf(grid)), version(faces, offsetsOf(faces)),
    version(faces, valuesOf(faces)), version(locations, offsetsOf(locations)),
    version(locations, valuesOf(locations)), version(nullptr, higherOrder.Degrees),
    version(nullptr, higherOrder.Weights) } };
}

Fingerprint versionOf(vtkUnstructuredGrid* grid)
{
  Fingerprint fingerprint;
  fingerprint.reserve(4 * GridContent::NumberOfArrays); // callers add to it
  for (const GridContent::Version& version : GridContent::versionsOf(grid))
  {
    fingerprint.push_back(reinterpret_cast<std::uintptr_t>(version.Owner));
    fingerprint.push_back(reinterpret_cast<std::uintptr_t>(version.Array));
    fingerprint.push_back(static_cast<std::uintptr_t>(version.Time));
  }
  return fingerprint;
}

void GridContent::read(vtkUnstructuredGrid* grid)
{
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
  return this->Hashes == other.Hashes;
}

bool GridContent::hasCellsOf(const GridContent& other) const
{
  return std::equal(
    this->Hashes.begin() + 1, this->Hashes.end(), other.Hashes.begin() + 1, other.Hashes.end());
}

} // namespace tetmarch
