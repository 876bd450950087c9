// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A data array becomes the scalars of vertices or tetrahedra.
#ifndef TetMarchMeshScalars_h
#define TetMarchMeshScalars_h

#include "Mesh/TetMesh.h"
#include "Mesh/TupleScalar.h"

#include <string>

class vtkDataArray;
class vtkUnstructuredGrid;

namespace tetmarch
{

/** The finite values that stored scalars 0 and 1 stand for; equal if there is one value or none. */
struct ScalarRange
{
  double Low = 0;
  double High = 0;
  bool AllFinite = true; // no value was stored as UndrawnScalar
  /** What a stored scalar of 1 lies above one of 0: never 0. */
  double width() const { return this->High > this->Low ? this->High - this->Low : 1; }
};

/** Empty if the array has one tuple for each of `count` points or cells (`what`); or what is wrong.
 */
std::string checkScalars(vtkDataArray* array, vtkIdType count, const char* what);

/** One scalar of each vertex, as it is in the array: in double precision, and NaN if it isn't
 * there.
 */
std::vector<double> pointValues(
  vtkUnstructuredGrid* grid, vtkDataArray* array, const TetMesh& mesh, const TupleScalar& scalar);
/** Of each tetrahedron. */
std::vector<double> cellValues(vtkDataArray* array, const TetMesh& mesh, const TupleScalar& scalar);

/** Of the values that are finite. */
ScalarRange finiteRange(const std::vector<double>& values);
/** The value as it is stored: 0..1, or UndrawnScalar. */
float storedScalar(double value, const ScalarRange& range);

/**
 * Fill Vertex::Scalar of the mesh from a point array (one tuple a point of the grid that the mesh
 * was built from), of each tuple one scalar. Values are brought to 0..1 in double precision before
 * rounding to float; what is not finite or not there becomes UndrawnScalar.
 */
ScalarRange setPointScalars(
  vtkUnstructuredGrid* grid, vtkDataArray* array, TetMesh& mesh, const TupleScalar& scalar = {});

/** One scalar a tetrahedron from a cell array, likewise. */
ScalarRange makeCellScalars(vtkDataArray* array, const TetMesh& mesh, std::vector<float>& scalars,
  const TupleScalar& scalar = {});

} // namespace tetmarch

#endif
