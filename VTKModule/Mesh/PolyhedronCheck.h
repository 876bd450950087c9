// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the faces of polyhedra can be read.
#ifndef TetMarchMeshPolyhedronCheck_h
#define TetMarchMeshPolyhedronCheck_h

#include "vtkType.h"

#include <string>

class vtkIdList;
class vtkIdTypeArray;
class vtkUnstructuredGrid;

namespace tetmarch
{

/** The arrays of faces, as vtkUnstructuredGrid has them; null without polyhedra. */
struct PolyhedronFaces
{
  vtkIdTypeArray* Faces;     // for each polyhedron: faces, then for each of them: points, ids
  vtkIdTypeArray* Locations; // for each cell: where its stream begins
  vtkIdType NumberOfPoints;  // of the grid

  explicit PolyhedronFaces(vtkUnstructuredGrid* grid);

  /** Empty if vtkUnstructuredGrid::GetFaceStream can read the polyhedron, whose faces then are one
   * or more, each of at least three points of the grid; or what is wrong. */
  std::string errorOf(vtkIdType cell) const;

  /** Of sound polyhedra, by their cell types: whether they name more values than there are. A few
   * faces that a million polyhedra share would become more tetrahedra than memory holds. */
  std::string errorOfSharing(const unsigned char* types, vtkIdType cells) const;

  /** Append the points that the faces of a sound polyhedron name, some more than once. */
  void addPoints(vtkIdType cell, vtkIdList* points) const;
};

} // namespace tetmarch

#endif
