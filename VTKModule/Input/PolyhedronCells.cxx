// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks the faces of polyhedra as stored by VTK from 9.4 on.
#include "Input/PolyhedronCheck.h"

#if !TETMARCH_FACES_ARE_STREAMS

#include "vtkCellArray.h"
#include "vtkIdList.h"

namespace tetmarch
{
namespace
{

std::string text(vtkIdType value) { return std::to_string(value); }

// An array of integers of any type.
class Numbers
{
public:
  explicit Numbers(vtkDataArray* array)
    : Array(array)
    , Wide(valuesOf<vtkTypeInt64>(array))
    , Narrow(valuesOf<vtkTypeInt32>(array))
  {
  }

  vtkIdType size() const { return this->Array->GetNumberOfValues(); }

  vtkIdType operator[](vtkIdType i) const
  {
    return this->Wide ? this->Wide[i] : this->Narrow ? this->Narrow[i] : this->computed(i);
  }

private:
  template <typename T>
  static const T* valuesOf(vtkDataArray* array)
  {
    auto* stored = vtkAOSDataArrayTemplate<T>::FastDownCast(array);
    return stored ? stored->GetPointer(0) : nullptr;
  }

  // Values that can't be an index become -1.
  vtkIdType computed(vtkIdType i) const
  {
    const double value = this->Array->GetComponent(i, 0);
    return 0.0 <= value && value <= 9e15 ? static_cast<vtkIdType>(value) : -1;
  }

  vtkDataArray* Array;
  const vtkTypeInt64* Wide;
  const vtkTypeInt32* Narrow;
};

// Reads a vtkCellArray with arbitrary values.
class Lists
{
public:
  explicit Lists(vtkCellArray* cells)
    : Offsets(cells->GetOffsetsArray())
    , Values(cells->GetConnectivityArray())
  {
  }

  vtkIdType count() const { return this->Offsets.size() - 1; }
  vtkIdType begin(vtkIdType list) const { return this->Offsets[list]; }
  vtkIdType end(vtkIdType list) const { return this->Offsets[list + 1]; }
  vtkIdType length(vtkIdType list) const { return this->end(list) - this->begin(list); }

  // Whether the list can be read at all.
  bool holds(vtkIdType list) const
  {
    return 0 <= this->begin(list) && this->begin(list) <= this->end(list) &&
           this->end(list) <= this->Values.size();
  }
  std::string errorOf(vtkIdType list, const std::string& name) const
  {
    return "The offsets of " + name + " say that it begins at " + text(this->begin(list)) +
           " and ends at " + text(this->end(list)) +
           "; they must not descend, and not go beyond the " + text(this->Values.size()) +
           " values there are.";
  }

private:
  Numbers Offsets;

public:
  Numbers Values;
};

} // namespace

std::string PolyhedronFaces::errorOfArrays(vtkIdType cell) const
{
  const std::string polyhedron = "polyhedron " + text(cell);
  const Lists cells(this->Locations);
  const Lists faces(this->Faces);
  if (cell >= cells.count())
  {
    return "The face locations have " + text(cells.count()) + " entries and so none for " +
           polyhedron + "; they must have one a cell.";
  }
  if (!cells.holds(cell))
  {
    return cells.errorOf(cell, "the face locations of " + polyhedron);
  }
  if (cells.length(cell) == 0)
  {
    return "The face locations give " + polyhedron + " no faces; it must have at least 1.";
  }
  for (vtkIdType i = cells.begin(cell); i < cells.end(cell); ++i)
  {
    const vtkIdType face = cells.Values[i];
    const auto name = [&] { return "face " + text(face) + ", which " + polyhedron + " has,"; };
    if (face < 0 || face >= faces.count())
    {
      return "The face locations of " + polyhedron + " name face " + text(face) +
             ", but there are " + text(faces.count()) + " faces.";
    }
    if (!faces.holds(face))
    {
      return faces.errorOf(face, name());
    }
    if (faces.length(face) < 3)
    {
      return "The offsets give " + name() + " " + text(faces.length(face)) +
             " points; it must have at least 3.";
    }
    for (vtkIdType k = faces.begin(face); k < faces.end(face); ++k)
    {
      const vtkIdType point = faces.Values[k];
      if (point < 0 || point >= this->NumberOfPoints)
      {
        return "The faces name point " + text(point) + " in " + name() + " but the grid has " +
               text(this->NumberOfPoints) + " points.";
      }
    }
  }
  return {};
}

vtkIdType PolyhedronFaces::valuesNamedBy(vtkIdType cell) const
{
  const Lists locations(this->Locations);
  const Lists faces(this->Faces);
  vtkIdType named = 0;
  for (vtkIdType i = locations.begin(cell); i < locations.end(cell); ++i)
  {
    named += faces.length(locations.Values[i]);
  }
  return named;
}

vtkIdType PolyhedronFaces::numberOfValues() const { return Lists(this->Faces).Values.size(); }

void PolyhedronFaces::addPoints(vtkIdType cell, vtkIdList* points) const
{
  const Lists locations(this->Locations);
  const Lists faces(this->Faces);
  for (vtkIdType i = locations.begin(cell); i < locations.end(cell); ++i)
  {
    const vtkIdType face = locations.Values[i];
    for (vtkIdType k = faces.begin(face); k < faces.end(face); ++k)
    {
      points->InsertNextId(faces.Values[k]);
    }
  }
}

} // namespace tetmarch

#endif
