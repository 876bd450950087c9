// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A data array becomes the stored scalars of a mesh.
#ifndef TetMarchMeshMeshScalars_h
#define TetMarchMeshMeshScalars_h

#include "Mesh/TetMesh.h"
#include "Scalars/DrawnScalars.h"
#include "Scalars/FurtherScalars.h"

class vtkUnstructuredGrid;

namespace tetmarch
{

/** The stored scalars of a mesh, beside those that its vertices have. */
struct MeshScalars
{
  std::vector<float> OfCells; // the first scalar of each tetrahedron; empty: the vertices have it
  ScalarRange Range;          // of the first scalar
  FurtherScalars Further;     // of each tetrahedron or of each vertex, likewise
};

/**
 * Read what is drawn of an array of the grid that the mesh was built from. The first scalar of an
 * array of points goes into Vertex::Scalar of the mesh. Values are brought to 0..1 in double
 * precision before they are rounded to float. Where the first or a further value is not finite or
 * not there, the first one becomes UndrawnScalar, and its range is not AllFinite.
 *
 * If the ranges of the whole are given (DrawnScalars::Whole), they take the place of those of the
 * values. Without an array there is nothing but these.
 */
MeshScalars readScalars(vtkUnstructuredGrid* grid, const DrawnScalars& drawn, TetMesh& mesh);

/** The ranges that readScalars() would find in the values: of the first scalar, then of further
 * ones. */
std::vector<FiniteRange> rangesOf(
  vtkUnstructuredGrid* grid, const DrawnScalars& drawn, const TetMesh& mesh);

} // namespace tetmarch

#endif
