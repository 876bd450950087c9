// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A bounding volume hierarchy of the boundary faces, in which rays search for entries.
#ifndef TetMarchMeshBoundaryHierarchy_h
#define TetMarchMeshBoundaryHierarchy_h

#include "Mesh/TetMesh.h"

namespace tetmarch
{

/** Maximum number of faces: node and face indices up to here are exact in float. */
constexpr std::size_t MostHierarchyFaces = std::size_t(1) << 23;

/** Maximum number of nodes on a path from the root to a leaf, and size of the traversal stack.
 */
constexpr int MostHierarchyDepth = 48;

/** Margin of the boxes: the predicate projects vertices with an error of a few 1e-7.
 */
constexpr float HierarchyMargin = 4e-6f;

/**
 * Build Hierarchy top-down with the binned surface area heuristic (Wald 2007), and sort
 * BoundaryFaces by its leaves. Nodes [0, ReentryNodes) cover the ReentryFaces faces through which a
 * ray can reenter, the other nodes those on the convex hull of the mesh. The links of boundary
 * faces must be set again afterwards.
 */
void buildHierarchy(TetMesh& mesh);

} // namespace tetmarch

#endif
