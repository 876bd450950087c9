// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Updates a mesh whose points have moved.
#ifndef TetMarchMeshMovedPoints_h
#define TetMarchMeshMovedPoints_h

#include "Mesh/TetMesh.h"

class vtkUnstructuredGrid;

namespace tetmarch
{

/**
 * Give a mesh the points of a grid with the same cells. The order of vertices and tetrahedra and
 * the links between tetrahedra are kept. The rest is made again, and scalars are 0. Returns false,
 * with an unspecified mesh, if buildTetMesh() must be used: cells were cut, other points
 * coincide than before, faces have more than two owners, tetrahedra are flat or not all oriented
 * like their neighbours, or points are invalid.
 */
bool movePoints(vtkUnstructuredGrid* grid, TetMesh& mesh);

} // namespace tetmarch

#endif
