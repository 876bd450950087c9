// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The orientation signs of the tetrahedra of a linked mesh.
#ifndef TetMarchMeshOutsideSigns_h
#define TetMarchMeshOutsideSigns_h

#include "Mesh/TetMesh.h"

#include <cstdint>
#include <vector>

namespace tetmarch
{

/**
 * For each tetrahedron the sign, +1 or -1, with which outwardFace() returns faces counter-clockwise
 * seen from outside. The mesh doesn't store the signs by which it was linked
 * (ConsistentOrientation.h), but they follow from its boundary faces, and the links propagate them
 * to all connected tetrahedra. If none of these has a boundary face, the volume of the first one
 * determines the sign.
 */
std::vector<std::int8_t> outsideSigns(const TetMesh& mesh);

} // namespace tetmarch

#endif
