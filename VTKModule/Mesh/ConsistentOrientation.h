// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Consistent orientation of neighbouring tetrahedra.
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
 * In a valid mesh two tetrahedra lie on opposite sides of their common face, and a ray passes from
 * one to the next without ever turning back. If some tetrahedra are inverted, both can lie on the
 * same side: a fold. The half-faces of folds, both of each pair, are returned and must not be
 * linked: rays then cross overlapping pieces one after the other, each forwards.
 *
 * Tetrahedra that are flat to within the rounding of positions have the sign 0. They take the sign
 * of their neighbours. If all connected tetrahedra are flat, the sum of their tiny volumes
 * determines the sign of all. Tetrahedra of one cell are also decided together: cutting a cell that
 * isn't convex inverts some of them, whose volume compensates the excess of the others. The signs
 * become +1 or -1.
 *
 * The links between tetrahedra must be set, but none to the outside.
 */
std::vector<Id> agreeOnSigns(const TetMesh& mesh, std::vector<std::int8_t>& signs);

} // namespace tetmarch

#endif
