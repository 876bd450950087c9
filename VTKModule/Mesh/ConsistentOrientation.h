// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The orientation of tetrahedra, such that neighbours agree on inside and outside.
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
 * passes from one to the next without ever turning back. Where some tetrahedra are turned inside
 * out, both lie on the same side: a fold. The half-faces of folds, both of each pair, are returned
 * and must not be linked: rays then pass overlapping pieces one after the other, each forwards.
 *
 * Tetrahedra that are flat to within the rounding of positions have no sign of their own (0). They
 * take that of their neighbours. Where all connected tetrahedra are flat, the sum of their tiny
 * volumes decides for all of them. Tetrahedra cut from one cell decide together too: cutting a cell
 * that isn't convex turns some of them inside out, and these take away the volume that the others
 * have too much. The signs become +1 or -1.
 *
 * The links between tetrahedra must be there, and none to the outside.
 */
std::vector<Id> agreeOnSigns(const TetMesh& mesh, std::vector<std::int8_t>& signs);

} // namespace tetmarch

#endif
