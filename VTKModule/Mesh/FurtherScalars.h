// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The scalars that are drawn together with the first one: other components of its array.
#ifndef TetMarchMeshFurtherScalars_h
#define TetMarchMeshFurtherScalars_h

#include "Mesh/Scalars.h"

#include <vector>

namespace tetmarch
{

/** As the arrays in Shaders/tables/table_buffers.glsl. */
constexpr int MostComponents = 4;

/** Which components of a tuple, at most three, and how they are stored. */
struct FurtherController
{
  std::vector<int> Components;
  /** Above 0: values are divided by it and stored as they are then, clamped to 0..1. 0: each
   * component is brought to 0..1 by its own range. */
  double Unit = 0;
};

struct FurtherScalars
{
  std::vector<float> Values;       // of a vertex or tetrahedron as many as there are ranges
  std::vector<ScalarRange> Ranges; // what stored values of 0 and 1 stand for

  std::size_t count() const { return this->Ranges.size(); }
};

/**
 * Of the vertices of a mesh whose Vertex::Scalar is set, which has that range. Where one of them
 * is not finite or not there, that scalar becomes UndrawnScalar, and the range knows.
 */
FurtherScalars furtherPointScalars(vtkUnstructuredGrid* grid, vtkDataArray* array,
  const FurtherController& choice, TetMesh& mesh, ScalarRange& range);

/** Of tetrahedra, whose first scalars are given, likewise. */
FurtherScalars furtherCellScalars(vtkDataArray* array, const FurtherController& choice,
  const TetMesh& mesh, std::vector<float>& scalars, ScalarRange& range);

} // namespace tetmarch

#endif
