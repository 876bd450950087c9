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
 * mesh can't reenter through it: no vertex of the boundary is outside its plane by more than the
 * rounding of positions (2^-21 mesh radii). The face then lies on the convex hull, which a ray
 * enters once, except for bumps of that size, which Shaders/march/ray_cast.glsl handles. This holds
 * only if the surface covers the hull once: if it is folded onto itself, or lies on the hull in
 * several parts, the result is false for all faces. It is also false if the search takes too long.
 * False is always safe.
 */
std::vector<bool> findHullFaces(const TetMesh& mesh);

} // namespace tetmarch

#endif
