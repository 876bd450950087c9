// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the tetrahedron behind each face.
#ifndef TetMarchMeshHalfFaceLinks_h
#define TetMarchMeshHalfFaceLinks_h

#include "Mesh/TetMesh.h"
#include "Parallel/Progress.h"

namespace tetmarch
{

/**
 * Fill Links and BoundaryFaces of a mesh from its tetrahedra. Of duplicate tetrahedra the first is
 * kept; but if two decomposed cells contain the same one on opposite sides, both are removed.
 * Owners of a face with more than two owners are linked in pairs on opposite sides, in the order of
 * their numbers. For the remaining owners it is a boundary face (in a mesh with cut cells only for
 * a single remaining one). It is also a boundary face for two owners on the same side
 * (ConsistentOrientation.h). False if progress requested a stop.
 */
bool linkHalfFaces(const Progress& progress, TetMesh& mesh);

/**
 * Set the links to the boundary faces in their current order.
 */
void linkBoundary(TetMesh& mesh);

} // namespace tetmarch

#endif
