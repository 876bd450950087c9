// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks the faces of polyhedra.
#ifndef TetMarchInputPolyhedronCheck_h
#define TetMarchInputPolyhedronCheck_h

#include "Input/GridVersions.h"

#include <string>

class vtkIdList;

namespace tetmarch
{

class CellTypes;

/** The arrays of faces of a vtkUnstructuredGrid. */
class PolyhedronFaces
{
public:
  explicit PolyhedronFaces(vtkUnstructuredGrid* grid);

  /** Empty if vtkUnstructuredGrid::GetFaceStream can read the polyhedron, which then has at least
   * one face, each with at least three points of the grid; else an error. */
  std::string errorOf(vtkIdType cell) const;

  /**
   * Whether valid polyhedra, by their cell types, refer to more values than exist, or to more than
   * twice as many if two of them can share a face. Otherwise a few faces shared by a million
   * polyhedra would become more tetrahedra than fit in memory.
   */
  std::string errorOfSharing(const CellTypes& types, vtkIdType cells) const;

  /** Append the points of the faces of a valid polyhedron, some more than once. */
  void addPoints(vtkIdType cell, vtkIdList* points) const;

private:
  // For existing arrays; in PolyhedronStreams.cxx or PolyhedronCells.cxx.
  std::string errorOfArrays(vtkIdType cell) const;
  vtkIdType valuesNamedBy(vtkIdType cell) const; // a valid polyhedron
  vtkIdType numberOfValues() const;              // of faces

  static constexpr int MostSharing = TETMARCH_FACES_ARE_STREAMS ? 1 : 2; // a face
  static constexpr const char* Advice = " Repair the grid's face arrays.";

  FaceArray* Faces;
  FaceArray* Locations;
  vtkIdType NumberOfPoints; // of the grid
};

} // namespace tetmarch

#endif
