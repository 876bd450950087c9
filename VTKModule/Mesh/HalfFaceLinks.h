// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the tetrahedron that lies behind each face.
#ifndef TetMarchMeshHalfFaceLinks_h
#define TetMarchMeshHalfFaceLinks_h

#include "Mesh/Progress.h"
#include "Mesh/TetMesh.h"

namespace tetmarch
{

/**
 * Fill Links and BoundaryFaces of a mesh that has its tetrahedra. Of duplicate tetrahedra the
 * first stays; but where two cells that were cut both claim one from opposite sides, both go. Of a
 * face with more than two owners those on opposite sides are linked in the order of their numbers.
 * For the remaining owners the face is boundary (in a mesh with cut cells only for one that is left
 * over). It is boundary also for two owners on the same side (ConsistentOrientation.h). False if
 * progress asked to stop.
 */
bool linkHalfFaces(const Progress& progress, TetMesh& mesh);

/**
 * Set the links to the boundary faces, in their present order.
 */
void linkBoundary(TetMesh& mesh);

} // namespace tetmarch

#endif
