// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The sides of a curvilinear grid that meet: where a ring closes, and at poles.
#ifndef TetMarchMeshJoinedSides_h
#define TetMarchMeshJoinedSides_h

#include "Mesh/TetMesh.h"

namespace tetmarch
{

/**
 * Of a mesh with a vertex for each point of a curvilinear grid. Positions are equal within their
 * rounding, 2^-24 of the radius of the mesh: the sine of a whole turn is not exactly 0.
 */
JoinedSides joinedSides(const TetMesh& mesh);

} // namespace tetmarch

#endif
