// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The drawn scalar of some tuples of an array.
#ifndef TetMarchMeshTupleValues_h
#define TetMarchMeshTupleValues_h

#include "Mesh/TetMesh.h"
#include "Scalars/TupleScalar.h"

#include <limits>
#include <vector>

class vtkDataArray;

namespace tetmarch
{

/** The value where an array has no tuple. */
constexpr double NotThere = std::numeric_limits<double>::quiet_NaN();

/** Scalars of the requested tuples: these, or those of the cells or points of a mesh. */
std::vector<double> scalarsOf(
  vtkDataArray* array, const std::vector<Id>& tuples, const TupleScalar& scalar);
std::vector<double> scalarsOf(
  vtkDataArray* array, const MeshArray<CellsOfTets>& tuples, const TupleScalar& scalar);
std::vector<double> scalarsOf(
  vtkDataArray* array, const MeshArray<PointsOfVertices>& tuples, const TupleScalar& scalar);

} // namespace tetmarch

#endif
