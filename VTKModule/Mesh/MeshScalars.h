// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The stored scalars of a mesh, read from a data array.
#ifndef TetMarchMeshMeshScalars_h
#define TetMarchMeshMeshScalars_h

#include "Mesh/TetMesh.h"
#include "Scalars/DrawnScalars.h"
#include "Scalars/ExtraScalars.h"

class vtkPointSet;

namespace tetmarch
{

/** The stored scalars of a mesh besides those of its vertices. */
struct MeshScalars
{
  std::vector<float> OfCells; // the first scalar of each tetrahedron; empty: stored in the vertices
  std::vector<std::array<float, 4>> OfCorners; // the first scalar of the corners of each
                                               // tetrahedron, if it jumps and is the only one
  bool Jump = false;  // scalars of points with equal coordinates differ (CornerScalars.h)
  ScalarRange Range;  // of the first scalar
  ExtraScalars Extra; // of each tetrahedron or of each vertex, likewise
};

/**
 * Read the drawn components of an array of the grid from which the mesh was built. The first scalar
 * of a point array is stored in Vertex::Scalar. Values are normalised to 0..1 in double precision
 * before they are rounded to float. If the first or an extra value is missing or not finite, the
 * first one becomes UndrawnScalar, and its range is not AllFinite.
 *
 * If the ranges of the whole volume are given (DrawnScalars::Whole), they replace those of the
 * values. Without an array only these are set.
 */
MeshScalars readScalars(vtkPointSet* grid, const DrawnScalars& drawn, TetMesh& mesh);

/** The ranges of the values as in readScalars(): of the first scalar, then of extra ones. */
std::vector<FiniteRange> rangesOf(
  vtkPointSet* grid, const DrawnScalars& drawn, const TetMesh& mesh);

} // namespace tetmarch

#endif
