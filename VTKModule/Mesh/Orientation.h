// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The side of a face on which its tetrahedron lies.
#ifndef TetMarchMeshOrientation_h
#define TetMarchMeshOrientation_h

#include "Mesh/TetMesh.h"

namespace tetmarch
{

/**
 * Six times the volume of the tetrahedron, its vertices taken by ascending id: above 0 if vertex 3
 * sees vertices 0, 1, 2 clockwise.
 */
double signedVolume(const TetMesh& mesh, Id tet);

/** The greatest change of six times a volume by the rounding of positions, from the square of the
 * longest edge at the vertex with the lowest id. Rounding of the sums is negligible: differences
 * and products of floats are exact in double. */
inline double volumeRounding(double square) { return square * 0x1p-22; }

/** Its sign; 0 if the tetrahedron is flat to within the rounding of positions. */
int volumeSign(const TetMesh& mesh, Id tet);

/** The parity, +1 or -1, of the permutation that moves vertex i of a tetrahedron to the end. */
inline int parity(Id i) { return i % 2 == 1 ? 1 : -1; }

/**
 * +1 if the tetrahedron of the half-face lies on the side towards which the normal of the face, its
 * vertices taken by ascending id, points; -1 on the other; 0 if it is flat.
 */
inline int inwardSide(const TetMesh& mesh, Id halfFace)
{
  return volumeSign(mesh, halfFace / 4) * parity(halfFace % 4);
}

/**
 * The boundary face of a half-face, counter-clockwise seen from outside, given the sign (+1 or -1)
 * of the signed volume of its tetrahedron.
 */
std::array<Id, 4> outwardFace(const TetMesh& mesh, Id halfFace, int sign);

} // namespace tetmarch

#endif
