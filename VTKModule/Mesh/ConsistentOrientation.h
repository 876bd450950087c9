// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// How tetrahedra are turned, so that those which hang together agree on inside and outside.
#ifndef TetMarchMeshConsistentOrientation_h
#define TetMarchMeshConsistentOrientation_h

#include "Mesh/TetMesh.h"

#include <cstdint>
#include <vector>

namespace tetmarch
{

/** volumeSign() of each tetrahedron, in parallel. */
std::vector<std::int8_t> volumeSigns(const TetMesh& mesh);

/**
 * Where a mesh is sound, two tetrahedra lie on opposite sides of their common face, and a ray
 * passes from one to the next without ever turning back. Where some are turned inside out, both lie
 * on the same side: a fold. Their half-faces, both of each pair, are returned, and not to be
 * linked: rays then pass overlapping pieces one after the other, each forwards.
 *
 * Tetrahedra that are flat to within the rounding of positions have no sign of their own (0). They
 * take it from their neighbours; where all that hang together are flat, their tiny volumes decide
 * together. Tetrahedra cut from one cell decide together too: cutting a cell that isn't convex
 * turns some of them inside out, which takes away what others have too much. The signs become +1 or
 * -1.
 *
 * Links between tetrahedra have to be there, none to the outside.
 */
std::vector<Id> agreeOnSigns(const TetMesh& mesh, std::vector<std::int8_t>& signs);

} // namespace tetmarch

#endif
