// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Tests whether a ray can leave the mesh and reenter.
#ifndef TetMarchMeshConvexity_h
#define TetMarchMeshConvexity_h

#include "Mesh/TetMesh.h"

namespace tetmarch
{

/**
 * Whether every ray crosses the mesh in one piece: the boundary is one closed surface, each edge
 * has two faces, no edge is concave or a fold by more than the rounding of positions to float
 * (2^-22 mesh radii), and no face is a needle that a ray could miss by rounding: less than 2^-18
 * mesh radii high, or 64 times as long as high. False is always safe.
 */
bool isConvex(const TetMesh& mesh);

} // namespace tetmarch

#endif
