// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the faces of polyhedra can be read.
#ifndef TetMarchInputPolyhedronCheck_h
#define TetMarchInputPolyhedronCheck_h

#include "Input/GridVersions.h"

#include <string>

class vtkIdList;

namespace tetmarch
{

class CellTypes;

/** The arrays of faces, as vtkUnstructuredGrid has them. */
class PolyhedronFaces
{
public:
  explicit PolyhedronFaces(vtkUnstructuredGrid* grid);

  /** Empty if vtkUnstructuredGrid::GetFaceStream can read the polyhedron, whose faces then are one
   * or more, each of at least three points of the grid; or what is wrong. */
  std::string errorOf(vtkIdType cell) const;

  /**
   * Whether sound polyhedra, by their cell types, name more values than there are, or more than
   * twice as many where two of them can share a face. A few faces that a million polyhedra share
   * would otherwise become more tetrahedra than memory holds.
   */
  std::string errorOfSharing(const CellTypes& types, vtkIdType cells) const;

  /** Append the points that the faces of a sound polyhedron name, some more than once. */
  void addPoints(vtkIdType cell, vtkIdList* points) const;

private:
  // Of arrays that are there; in PolyhedronStreams.cxx or PolyhedronCells.cxx.
  std::string errorOfArrays(vtkIdType cell) const;
  vtkIdType valuesNamedBy(vtkIdType cell) const; // a sound polyhedron
  vtkIdType numberOfValues() const;              // of faces

  static constexpr int MostSharing = TETMARCH_FACES_ARE_STREAMS ? 1 : 2; // a face
  static constexpr const char* Advice = " Repair the grid's face arrays.";

  FaceArray* Faces;
  FaceArray* Locations;
  vtkIdType NumberOfPoints; // of the grid
};

} // namespace tetmarch

#endif
