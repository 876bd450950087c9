// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/PolyhedronCheck.h"

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

} // namespace tetmarch
