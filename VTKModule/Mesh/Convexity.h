// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a ray can leave the mesh and come back.
#ifndef TetMarchMeshConvexity_h
#define TetMarchMeshConvexity_h

#include "TetMesh.h"

namespace tetmarch
{

/**
 * Whether the boundary is one closed surface, each edge of which has two faces and no edge of which
 * is concave by more than the rounding of positions to float (2^-22 mesh radii): then the mesh is
 * convex, and every ray meets it once.
 */
bool isConvex(const TetMesh& mesh);

} // namespace tetmarch

#endif
