// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RawFaces.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

namespace tetmarch::testing
{
Ids valuesOf(vtkDataArray* array)
{
  Ids values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(static_cast<vtkIdType>(array->GetTuple1(i)));
  }
  return values;
}

#if TETMARCH_FACES_ARE_STREAMS

RawFaces::RawFaces(vtkUnstructuredGrid* grid)
  : Locations(valuesOf(faceLocationsOf(grid)))
  , Streams(valuesOf(facesOf(grid)))
{
}

void RawFaces::add(const std::vector<Ids>& faces)
{
  this->Locations.push_back(static_cast<vtkIdType>(this->Streams.size()));
  this->Streams.push_back(static_cast<vtkIdType>(faces.size()));
  for (const Ids& face : faces)
  {
    this->Streams.push_back(static_cast<vtkIdType>(face.size()));
    this->Streams.insert(this->Streams.end(), face.begin(), face.end());
  }
}

void RawFaces::addNone() { this->Locations.push_back(-1); }

std::vector<Ids*> RawFaces::locationArrays() { return { &this->Locations }; }
std::vector<Ids*> RawFaces::faceArrays() { return { &this->Streams }; }

vtkSmartPointer<FaceArray> RawFaces::locations() const
{
  return arrayOf<vtkIdTypeArray>(this->Locations);
}

vtkSmartPointer<FaceArray> RawFaces::faces() const
{
  return arrayOf<vtkIdTypeArray>(this->Streams);
}

void setCells(vtkUnstructuredGrid* grid, vtkDataArray* types, vtkCellArray* cells,
  FaceArray* faceLocations, FaceArray* faces)
{
  grid->SetCells(vtkUnsignedCharArray::SafeDownCast(types), cells, faceLocations, faces);
}

#else

namespace
{
vtkSmartPointer<vtkCellArray> listsOf(const Ids& offsets, const Ids& values)
{
  auto lists = vtkSmartPointer<vtkCellArray>::New();
  lists->SetData(
    arrayOf<vtkTypeInt64Array>(offsets).Get(), arrayOf<vtkTypeInt64Array>(values).Get());
  return lists;
}
} // namespace

RawFaces::RawFaces(vtkUnstructuredGrid* grid)
{
  if (faceLocationsOf(grid) && facesOf(grid))
  {
    this->LocationOffsets = valuesOf(faceLocationsOf(grid)->GetOffsetsArray());
    this->Locations = valuesOf(faceLocationsOf(grid)->GetConnectivityArray());
    this->Offsets = valuesOf(facesOf(grid)->GetOffsetsArray());
    this->Points = valuesOf(facesOf(grid)->GetConnectivityArray());
  }
}

void RawFaces::add(const std::vector<Ids>& faces)
{
  for (const Ids& face : faces)
  {
    this->Locations.push_back(static_cast<vtkIdType>(this->Offsets.size()) - 1);
    this->Points.insert(this->Points.end(), face.begin(), face.end());
    this->Offsets.push_back(static_cast<vtkIdType>(this->Points.size()));
  }
  this->addNone();
}

void RawFaces::addNone()
{
  this->LocationOffsets.push_back(static_cast<vtkIdType>(this->Locations.size()));
}

std::vector<Ids*> RawFaces::locationArrays()
{
  return { &this->LocationOffsets, &this->Locations };
}
std::vector<Ids*> RawFaces::faceArrays() { return { &this->Offsets, &this->Points }; }

vtkSmartPointer<FaceArray> RawFaces::locations() const
{
  return listsOf(this->LocationOffsets, this->Locations);
}

vtkSmartPointer<FaceArray> RawFaces::faces() const { return listsOf(this->Offsets, this->Points); }

void setCells(vtkUnstructuredGrid* grid, vtkDataArray* types, vtkCellArray* cells,
  FaceArray* faceLocations, FaceArray* faces)
{
  grid->SetPolyhedralCells(types, cells, faceLocations, faces);
}

#endif
} // namespace tetmarch::testing
