// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Updates a mesh whose points moved while its cells stayed.
#ifndef TetMarchMeshMovedPoints_h
#define TetMarchMeshMovedPoints_h

#include "Mesh/TetMesh.h"

class vtkUnstructuredGrid;

namespace tetmarch
{

/**
 * Give a mesh the points of a grid that has exactly the cells it was made of. What follows from
 * cells alone is kept: the order of vertices and tetrahedra, and the links between tetrahedra. The
 * rest is made again, and scalars are 0. Returns false, with an unspecified mesh, if buildTetMesh()
 * has to make it instead: cells were cut, faces have more than two owners, tetrahedra are flat or
 * not all oriented like their neighbours, or something is wrong with the points.
 */
bool movePoints(vtkUnstructuredGrid* grid, TetMesh& mesh);

} // namespace tetmarch

#endif
