// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Which tetrahedron lies behind each face.
#ifndef TetMarchMeshHalfFaceLinks_h
#define TetMarchMeshHalfFaceLinks_h

#include "Progress.h"
#include "TetMesh.h"

namespace tetmarch
{

/**
 * Fill Links and BoundaryFaces of a mesh whose tetrahedra are there. Duplicate tetrahedra are
 * dropped (the first stays). Of a face with more than two owners the one with the lowest number is
 * linked to the first one on the other side; to the rest the face is boundary. False if progress
 * asked to stop.
 */
bool linkHalfFaces(const Progress& progress, TetMesh& mesh);

/**
 * Set the links between the boundary faces, in their present order, and the tetrahedra.
 */
void linkBoundary(TetMesh& mesh);

} // namespace tetmarch

#endif
