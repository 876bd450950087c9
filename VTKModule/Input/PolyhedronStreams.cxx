// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks the faces of polyhedra as stored by VTK up to 9.3.
#include "Input/PolyhedronCheck.h"

#if TETMARCH_FACES_ARE_STREAMS

#include "vtkIdList.h"
#include "vtkIdTypeArray.h"

namespace tetmarch
{
namespace
{

std::string text(vtkIdType value) { return std::to_string(value); }

} // namespace

std::string PolyhedronFaces::errorOfArrays(vtkIdType cell) const
{
  const std::string polyhedron = "polyhedron " + text(cell);
  if (cell >= this->Locations->GetNumberOfValues())
  {
    return "The face locations have " + text(this->Locations->GetNumberOfValues()) +
           " values and so none for " + polyhedron + "; they must have one a cell.";
  }
  const vtkIdType size = this->Faces->GetNumberOfValues();
  const vtkIdType* faces = this->Faces->GetPointer(0);
  vtkIdType at = this->Locations->GetValue(cell);
  if (at < 0 || at >= size)
  {
    return "The face locations say that the faces of " + polyhedron + " begin at " + text(at) +
           ", but the faces have " + text(size) + " values.";
  }
  const vtkIdType count = faces[at++];
  if (count < 1 || count > (size - at) / 4)
  {
    return "The faces give " + polyhedron + " " + text(count) +
           " faces; it must have at least 1, and " + text(size - at) +
           " more values have room for " + text((size - at) / 4) + " at most.";
  }
  for (vtkIdType face = 0; face < count; ++face)
  {
    const vtkIdType corners = at < size ? faces[at++] : 0;
    if (corners < 3 || corners > size - at)
    {
      return "The faces give face " + text(face) + " of " + polyhedron + " " + text(corners) +
             " points; it must have at least 3, and " + text(size - at) + " more values are there.";
    }
    for (const vtkIdType end = at + corners; at < end; ++at)
    {
      if (faces[at] < 0 || faces[at] >= this->NumberOfPoints)
      {
        return "The faces of " + polyhedron + " name point " + text(faces[at]) + " in face " +
               text(face) + ", but the grid has " + text(this->NumberOfPoints) + " points.";
      }
    }
  }
  return {};
}

vtkIdType PolyhedronFaces::valuesNamedBy(vtkIdType cell) const
{
  const vtkIdType* begin = this->Faces->GetPointer(this->Locations->GetValue(cell));
  const vtkIdType* at = begin + 1;
  for (vtkIdType face = 0; face < *begin; ++face)
  {
    at += 1 + *at;
  }
  return at - begin;
}

vtkIdType PolyhedronFaces::numberOfValues() const { return this->Faces->GetNumberOfValues(); }

void PolyhedronFaces::addPoints(vtkIdType cell, vtkIdList* points) const
{
  const vtkIdType* at = this->Faces->GetPointer(this->Locations->GetValue(cell));
  for (vtkIdType faces = *at++; faces > 0; --faces)
  {
    for (vtkIdType corners = *at++; corners > 0; --corners)
    {
      points->InsertNextId(*at++);
    }
  }
}

} // namespace tetmarch

#endif
