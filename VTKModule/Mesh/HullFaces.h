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
 * For each boundary face, in the order of the hierarchy that the mesh has, whether a ray that has
 * left the mesh can't come back in through it: no vertex of the boundary stands out over its plane
 * by more than the rounding of positions (2^-21 mesh radii), so it lies on the convex hull, into
 * which a ray comes once, but for bumps of that size, which Shaders/march/ray_cast.glsl sees to.
 * That holds only where the surface covers the hull once: if it is folded onto itself there, or
 * lies on it in several parts, no face is taken. Nor are faces for which the search gets long. Not
 * to be taken is always safe.
 */
std::vector<bool> findHullFaces(const TetMesh& mesh);

} // namespace tetmarch

#endif
