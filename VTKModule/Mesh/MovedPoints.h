// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A mesh whose points move while its cells stay.
#ifndef TetMarchMeshMovedPoints_h
#define TetMarchMeshMovedPoints_h

#include "Mesh/TetMesh.h"

class vtkUnstructuredGrid;

namespace tetmarch
{

/**
 * Give a mesh the points of a grid that has the very cells that it was made of. What follows from
 * cells alone is kept: the order of vertices, tetrahedra and the links between these; the rest is
 * made anew, scalars are left 0. False, with a mesh that is unspecified, if that isn't enough and
 * buildTetMesh has to do it: cells were cut, faces have more than two owners, tetrahedra are flat
 * or not all turned like their neighbours, or something is wrong with the points.
 */
bool movePoints(vtkUnstructuredGrid* grid, TetMesh& mesh);

} // namespace tetmarch

#endif
