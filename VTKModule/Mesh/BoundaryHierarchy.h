// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A bounding volume hierarchy of the boundary faces, in which rays look for entries.
#ifndef TetMarchMeshBoundaryHierarchy_h
#define TetMarchMeshBoundaryHierarchy_h

#include "Mesh/TetMesh.h"

namespace tetmarch
{

/** Node and face numbers are exact in float up to here. */
constexpr std::size_t MostHierarchyFaces = std::size_t(1) << 23;

/** The most nodes on the path from the root to a leaf: so many nodes a traversal has to remember.
 */
constexpr int MostHierarchyDepth = 48;

/** Boxes are larger by this than exact: the predicate projects vertices with a few 1e-7 of error.
 */
constexpr float HierarchyMargin = 4e-6f;

/**
 * Build Hierarchy top-down with the binned surface area heuristic (Wald 2007), and bring
 * BoundaryFaces into the order of its leaves. The first ReentryNodes nodes hold the ReentryFaces
 * faces through which a ray can enter again, the other nodes those on the convex hull of the mesh.
 * The links of boundary faces must be set again afterwards.
 */
void buildHierarchy(TetMesh& mesh);

} // namespace tetmarch

#endif
