// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How the tetrahedra of a linked mesh are turned.
#ifndef TetMarchMeshOutsideSigns_h
#define TetMarchMeshOutsideSigns_h

#include "Mesh/TetMesh.h"

#include <cstdint>
#include <vector>

namespace tetmarch
{

/**
 * For each tetrahedron the sign, +1 or -1, by which outwardFace() gives faces that turn
 * counter-clockwise seen from outside. The mesh doesn't keep those by which it was linked
 * (ConsistentOrientation.h), but its boundary faces tell them, and its links carry them on to all
 * that hang together. Where none of these has a boundary face, the first one's volume decides.
 */
std::vector<std::int8_t> outsideSigns(const TetMesh& mesh);

} // namespace tetmarch

#endif
