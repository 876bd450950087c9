// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Boundary faces that lie on the convex hull of the mesh.
#ifndef TetMarchMeshHullFaces_h
#define TetMarchMeshHullFaces_h

#include "Mesh/TetMesh.h"

#include <vector>

namespace tetmarch
{

/**
 * For each boundary face, in the order of the mesh's hierarchy, whether a ray that has left the
 * mesh can't enter again through it: no vertex of the boundary lies farther out than its plane by
 * more than the rounding of positions (2^-21 mesh radii). The face then lies on the convex hull,
 * which a ray enters once, except for bumps of that size, which Shaders/march/ray_cast.glsl
 * handles. That holds only where the surface covers the hull once: where it is folded onto itself,
 * or lies on the hull in several parts, no face is taken. Faces for which the search gets long are
 * not taken either. Not to take a face is always safe.
 */
std::vector<bool> findHullFaces(const TetMesh& mesh);

} // namespace tetmarch

#endif
