// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/PolyhedronCheck.h"

#include "Input/CellTypes.h"

#include "vtkCellType.h"

namespace tetmarch
{

PolyhedronFaces::PolyhedronFaces(vtkUnstructuredGrid* grid)
  : Faces(facesOf(grid))
  , Locations(faceLocationsOf(grid))
  , NumberOfPoints(grid->GetNumberOfPoints())
{
}

std::string PolyhedronFaces::errorOf(vtkIdType cell) const
{
  if (this->Faces && this->Locations)
  {
    const std::string error = this->errorOfArrays(cell);
    return error.empty() ? error : error + Advice;
  }
  return "The grid has polyhedron " + std::to_string(cell) + " but no " +
         (this->Faces ? "face locations." : "faces.") + " Give it both when its cells are set.";
}

std::string PolyhedronFaces::errorOfSharing(const CellTypes& types, vtkIdType cells) const
{
  vtkIdType named = 0;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    if (types[cell] != VTK_POLYHEDRON)
    {
      continue;
    }
    named += this->valuesNamedBy(cell);
    if (named > MostSharing * this->numberOfValues())
    {
      return "The polyhedra up to cell " + std::to_string(cell) +
             " share too many faces: by their face locations they name " + std::to_string(named) +
             " values of faces, of which there are " + std::to_string(this->numberOfValues()) +
             ". A face is that of " +
             (MostSharing == 1 ? "one polyhedron." : "two polyhedra at most.") + Advice;
    }
  }
  return {};
}

} // namespace tetmarch
