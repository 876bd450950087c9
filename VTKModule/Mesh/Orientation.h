// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// On which side of a face its tetrahedron lies.
#ifndef TetMarchMeshOrientation_h
#define TetMarchMeshOrientation_h

#include "TetMesh.h"

namespace tetmarch
{

/**
 * +1 if the tetrahedron of the half-face lies on the side towards which the normal of the face, its
 * vertices taken by ascending id, points; -1 on the other; 0 if the tetrahedron is flat to within
 * the rounding of positions.
 */
int inwardSide(const TetMesh& mesh, Id halfFace);

/**
 * The boundary face of a half-face, counter-clockwise seen from outside. A flat tetrahedron takes
 * its orientation from the nearest one that isn't, by way of links.
 */
std::array<Id, 4> outwardFace(const TetMesh& mesh, Id halfFace);

} // namespace tetmarch

#endif
