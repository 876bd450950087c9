// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Counts of defects of a grid that were repaired or left out.
#ifndef TetMarchMeshMeshReport_h
#define TetMarchMeshMeshReport_h

#include "vtkType.h"

#include <string>

namespace tetmarch
{

/** For one warning to the user. */
struct MeshReport
{
  vtkIdType LowDimensionalCells = 0;  // vertices, lines, surfaces: skipped
  vtkIdType UnsupportedCells = 0;     // 3D cells that can't be decomposed: skipped
  vtkIdType DegenerateTetrahedra = 0; // with a repeated point: dropped
  vtkIdType DuplicateTetrahedra = 0;  // the same four points again: dropped
  vtkIdType NonManifoldFaces = 0;     // owners without a counterpart: boundary faces for them
  vtkIdType FoldedFaces = 0;          // with both tetrahedra on one side: boundary faces for both
};

/** A sentence for each count that is not 0, except surfaces and lines beside 3D cells, which are
 * common. */
std::string describe(const MeshReport& report);

} // namespace tetmarch

#endif
